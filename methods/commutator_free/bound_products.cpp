// SPDX-License-Identifier: BSD-3-Clause
#include "methods/commutator_free/bound_products.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <string>

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// The product over the `before` stages that may be used; `what` names it in messages.
BoundProduct bound(const ExponentialProduct& product, std::size_t before, std::size_t stride, const std::string& what) {
    const auto fail = [&](const std::string& fault) {
        throw std::invalid_argument(what + " of a commutator-free scheme " + fault);
    };
    const auto latest = std::to_string(std::max<std::size_t>(before, 1));
    if (product.from < 1 || static_cast<std::size_t>(product.from) > std::max<std::size_t>(before, 1))
        fail("starts from stage " + std::to_string(product.from) + ", not from one of 1 to " + latest);
    BoundProduct numbers{static_cast<std::size_t>(product.from - 1), {}};
    for (const auto& factor : product.factors) {
        if (factor.size() > before)
            fail("has a factor of " + std::to_string(factor.size()) + " slopes, and " + std::to_string(before) +
                 " are known");
        Combination terms;
        for (std::size_t j = 0; j < factor.size(); ++j)
            if (!factor[j].is_zero()) terms.push_back({value(factor[j]), j * stride});
        if (terms.empty()) fail("has a factor without slopes");
        numbers.factors.push_back(terms);
    }
    return numbers;
}

/// The weight of each slope in a product: what is left of it where all commute.
std::vector<Real> weights(const BoundProduct& product, const std::vector<std::vector<Real>>& of_stages,
                          std::size_t stages, std::size_t stride) {
    std::vector<Real> sum = of_stages.empty() ? std::vector<Real>(stages, 0) : of_stages[product.from];
    for (const Combination& factor : product.factors)
        for (const Term& term : factor) sum[term.offset / stride] += term.coefficient;
    return sum;
}

Real total(const std::vector<Real>& numbers) { return std::accumulate(numbers.begin(), numbers.end(), Real(0)); }

void check_product(const std::vector<Real>& weights, const char* what) {
    Real size = 1;  // coefficients are rounded, and may be larger than 1
    for (const Real& weight : weights) size += abs(weight);
    if (!(abs(total(weights) - 1) <= 64 * epsilon * size))
        throw std::invalid_argument(std::string("the coefficients of the ") + what +
                                    " of a commutator-free scheme do not sum to 1");
}

}  // namespace

int stages_of_step(const CommutatorFreeScheme& scheme) {
    const auto last_used = [](const ExponentialProduct& product) {
        std::size_t last = static_cast<std::size_t>(product.from);
        for (const auto& factor : product.factors)
            for (std::size_t j = 0; j < factor.size(); ++j)
                if (!factor[j].is_zero()) last = std::max(last, j + 1);
        return last;
    };
    return static_cast<int>(last_used(scheme.result));
}

BoundProducts::BoundProducts(const CommutatorFreeScheme& scheme, std::size_t stride) {
    const std::size_t s = scheme.stages.size();
    std::vector<std::vector<Real>> of_stages;
    for (std::size_t i = 0; i < s; ++i) {
        stages.push_back(bound(scheme.stages[i], i, stride, "stage " + std::to_string(i + 1)));
        of_stages.push_back(weights(stages.back(), of_stages, s, stride));
        c.push_back(total(of_stages.back()));
    }
    result = bound(scheme.result, s, stride, "the result");
    check_product(weights(result, of_stages, s, stride), "result");
    embedded = bound(scheme.embedded, s, stride, "the embedded result");
    if (!embedded.factors.empty()) check_product(weights(embedded, of_stages, s, stride), "embedded result");
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
