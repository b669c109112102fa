// SPDX-License-Identifier: BSD-3-Clause
//
// Order conditions of commutator-free methods, whose exponentials contain combinations of slopes: stage i and the
// result are
//   prod_l exp(sum_j alpha_lj K_j),  l ascending in the left-trivialised product [celledoni2003cf].
// B+ is linear, so a combination of slopes is the same combination of the stages' series, and the rest is as for
// Crouch-Grossman methods, which are the case of one slope in each factor.
#pragma once

#include "tests/judges/conditions/ordered_forests.hpp"

namespace kreisel::orders {

/// A factor holds the weights of the slopes before it; trailing zeros may be left out.
template <class T>
struct CommutatorFree {
    using Product = std::vector<std::vector<T>>;
    std::vector<Product> stages;  ///< the first is empty: Y_1 = y
    Product result;
};

/// prod_l exp(sum_j factor_lj B+(stage_j)).
template <class T>
Series<T> product_of(const OrderedForests& forests, const typename CommutatorFree<T>::Product& factors,
                     const std::vector<Series<T>>& stages) {
    Series<T> y = one<T>(forests);
    for (const std::vector<T>& factor : factors) {
        Series<T> combination(forests.size(), T(0));
        for (std::size_t j = 0; j < factor.size(); ++j)
            for (std::size_t w = 0; w < forests.size(); ++w) combination[w] += factor[j] * stages.at(j)[w];
        y = append_exponential(forests, y, T(1), combination);
    }
    return y;
}

/// One step with h = 1.
template <class T>
Series<T> commutator_free_series(const OrderedForests& forests, const CommutatorFree<T>& method) {
    std::vector<Series<T>> stages;
    for (const auto& factors : method.stages) stages.push_back(product_of(forests, factors, stages));
    return product_of(forests, method.result, stages);
}

/// Largest p up to 5 such that method and flow agree within `slack` on all Lyndon words with up to p nodes.
inline int commutator_free_order(const CommutatorFree<Rational>& method, const Rational& slack = 0) {
    return flow_order(5, slack, [&](const OrderedForests& forests) { return commutator_free_series(forests, method); });
}

}  // namespace kreisel::orders
