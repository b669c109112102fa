// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tests/orders/crouch_grossman_conditions.hpp"
#include "tests/orders/registered.hpp"

namespace kreisel::orders {

/// Largest p up to 5 such that the conditions of the orders 1 to p hold within `slack`, for a method that takes its
/// factors in the given orders.
inline int crouch_grossman_order(const NumericTableau<Rational>& tableau, const Rational& slack,
                                 Factors stage_factors = Factors::ascending,
                                 Factors final_factors = Factors::ascending) {
    int order = 0;
    while (order < 5 && all_within(conditions_of_order(tableau, order + 1, stage_factors, final_factors), slack)) ++order;
    return order;
}

}  // namespace kreisel::orders
