// SPDX-License-Identifier: BSD-3-Clause
//
// Order conditions of Crouch-Grossman methods, generated from ordered_forests.hpp.
#pragma once

#include <utility>

#include "tests/judges/conditions/ordered_forests.hpp"

namespace kreisel::orders {

/// Method minus flow on the Lyndon words with exactly `order` nodes.
template <class T>
std::vector<T> conditions_of_order(const NumericTableau<T>& tableau, int order,
                                   Factors stage_factors = Factors::ascending,
                                   Factors final_factors = Factors::ascending) {
    const OrderedForests forests(order);
    const auto method = crouch_grossman_series(forests, tableau, stage_factors, final_factors);
    const auto flow = exact_series<T>(forests);
    std::vector<T> residuals;
    for (const std::size_t w : forests.lyndon(order)) residuals.push_back(method[w] - flow[w]);
    return residuals;
}

/// Largest p up to 5 such that the conditions of the orders 1 to p hold within `slack`, for a method that takes its
/// factors in the given orders.
inline int crouch_grossman_order(const NumericTableau<Rational>& tableau, const Rational& slack,
                                 Factors stage_factors = Factors::ascending,
                                 Factors final_factors = Factors::ascending) {
    int order = 0;
    while (order < 5 && all_within(conditions_of_order(tableau, order + 1, stage_factors, final_factors), slack))
        ++order;
    return order;
}

/// Those of the solution and of the one embedded in it; 0 where there is none.
inline std::pair<int, int> crouch_grossman_orders(NumericTableau<Rational> tableau, const Rational& slack) {
    const int step = crouch_grossman_order(tableau, slack);
    if (tableau.b_hat.empty()) return {step, 0};
    tableau.b = tableau.b_hat;
    return {step, crouch_grossman_order(tableau, slack)};
}

}  // namespace kreisel::orders
