// SPDX-License-Identifier: BSD-3-Clause
//
// Order conditions of Crouch-Grossman methods as a system of polynomial equations in the coefficients of an explicit
// tableau, with its Jacobian; generated from ordered_forests.hpp.
#pragma once

#include <Eigen/Core>
#include <boost/multiprecision/eigen.hpp>

#include "tests/orders/ordered_forests.hpp"

namespace kreisel::orders {

using Vector100 = Eigen::Matrix<Float100, Eigen::Dynamic, 1>;
using Matrix100 = Eigen::Matrix<Float100, Eigen::Dynamic, Eigen::Dynamic>;

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

/// All coefficients, rows of `a` first, then b.
Vector100 unknowns(const NumericTableau<Float100>& tableau);
NumericTableau<Float100> tableau_of(const Vector100& unknowns, std::size_t stages);

/// Conditions of the orders 1 to `order`, one after another.
Vector100 conditions(const Vector100& unknowns, std::size_t stages, int order);
/// Their derivatives by one-sided differences of width 1e-50, so correct to some 50 digits.
Matrix100 conditions_jacobian(const Vector100& unknowns, std::size_t stages, int order);

}  // namespace kreisel::orders
