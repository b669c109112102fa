// SPDX-License-Identifier: BSD-3-Clause
#include "methods/tableaus/bound_tableau.hpp"

#include <algorithm>
#include <stdexcept>

namespace kreisel {
inline namespace KREISEL_PRECISION {

Real value(const Coefficient& c) { return c.digits ? from_text(c.digits) : Real(c.numerator) / Real(c.denominator); }

namespace {

Combination nonzero(const std::vector<Coefficient>& row, std::size_t stride) {
    Combination terms;
    for (std::size_t j = 0; j < row.size(); ++j)
        if (!row[j].is_zero()) terms.push_back({value(row[j]), j * stride});
    return terms;
}

Real sum(const Combination& terms) {
    Real total = 0;
    for (const Term& term : terms) total += term.coefficient;
    return total;
}

/// Of exact coefficients, so that a weight that both solutions share leaves no term.
Combination difference(const std::vector<Coefficient>& b, const std::vector<Coefficient>& b_hat, std::size_t stride) {
    Combination terms;
    for (std::size_t j = 0; j < b.size(); ++j)
        if (!(b[j] == b_hat[j])) terms.push_back({value(b[j]) - value(b_hat[j]), j * stride});
    return terms;
}

void check_size(const char* what, std::size_t entries, std::size_t stages) {
    if (entries != stages)
        throw std::invalid_argument("tableau with " + std::to_string(stages) + " rows and " + std::to_string(entries) +
                                    " " + what);
}

/// Coefficients are rounded, and may be larger than 1.
Real slack(const Combination& terms) {
    Real size = 1;
    for (const Term& term : terms) size += abs(term.coefficient);
    return 64 * epsilon * size;
}

void check_weights(const char* what, const Combination& weights) {
    if (!(abs(sum(weights) - 1) <= slack(weights)))
        throw std::invalid_argument(std::string("the ") + what + " of the tableau do not sum to 1");
}

}  // namespace

int stages_of_step(const Tableau& tableau) {
    std::size_t last = tableau.b.size();
    while (last > 0 && tableau.b[last - 1].is_zero()) --last;
    return static_cast<int>(last);
}

bool first_same_as_last(const Tableau& tableau) {
    if (tableau.b_hat.empty() || !tableau.b.back().is_zero()) return false;
    const std::vector<Coefficient>& row = tableau.a.back();
    return row.size() + 1 == tableau.b.size() && std::equal(row.begin(), row.end(), tableau.b.begin());
}

BoundTableau::BoundTableau(const Tableau& tableau, std::size_t stride)
    : stages_of_step(static_cast<std::size_t>(kreisel::stages_of_step(tableau))),
      first_same_as_last(kreisel::first_same_as_last(tableau)),
      b(nonzero(tableau.b, stride)) {
    check_size("weights", tableau.b.size(), tableau.a.size());
    check_weights("weights", b);
    for (std::size_t i = 0; i < tableau.a.size(); ++i) {
        if (tableau.a[i].size() > i)
            throw std::invalid_argument("row " + std::to_string(i + 1) + " of an explicit tableau has " +
                                        std::to_string(tableau.a[i].size()) + " entries, more than " +
                                        std::to_string(i));
        a.push_back(nonzero(tableau.a[i], stride));
        c.push_back(sum(a.back()));
    }
    if (!tableau.c.empty()) {
        check_size("nodes", tableau.c.size(), tableau.a.size());
        for (std::size_t i = 0; i < c.size(); ++i)
            if (!(abs(c[i] - value(tableau.c[i])) <= slack(a[i])))
                throw std::invalid_argument("row " + std::to_string(i + 1) +
                                            " of the tableau does not sum to its node");
    }
    bind_dense(tableau, stride);
    if (tableau.b_hat.empty()) return;
    check_size("embedded weights", tableau.b_hat.size(), tableau.a.size());
    check_weights("embedded weights", nonzero(tableau.b_hat, stride));
    error = difference(tableau.b, tableau.b_hat, stride);
}

void BoundTableau::bind_dense(const Tableau& tableau, std::size_t stride) {
    if (tableau.dense.empty()) return;
    check_size("rows of dense output", tableau.dense.size(), tableau.a.size());
    for (std::size_t i = 0; i < tableau.dense.size(); ++i) {
        if (tableau.dense[i].empty()) continue;
        DenseWeight weight{.coefficients = {}, .offset = i * stride};
        for (const Coefficient& c : tableau.dense[i]) weight.coefficients.push_back(value(c));
        dense.push_back(std::move(weight));
    }
}

void BoundTableau::weigh(const Real& theta, Combination& weights) const {
    for (std::size_t i = 0; i < dense.size(); ++i) {
        Real sum = 0;
        for (auto c = dense[i].coefficients.rbegin(); c != dense[i].coefficients.rend(); ++c) sum = theta * (sum + *c);
        weights[i] = {sum, dense[i].offset};
    }
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
