// SPDX-License-Identifier: BSD-3-Clause
//
// The order conditions of Crouch-Grossman methods as one system of polynomial equations, with its Jacobian, in 100
// digits.
#pragma once

#include <Eigen/Core>
#include <boost/multiprecision/eigen.hpp>

#include "tests/judges/conditions/crouch_grossman_conditions.hpp"

namespace kreisel::orders {

using Vector100 = Eigen::Matrix<Float100, Eigen::Dynamic, 1>;
using Matrix100 = Eigen::Matrix<Float100, Eigen::Dynamic, Eigen::Dynamic>;

/// All coefficients, rows of `a` first, then b.
Vector100 unknowns(const NumericTableau<Float100>& tableau);
NumericTableau<Float100> tableau_of(const Vector100& unknowns, std::size_t stages);

/// Conditions of the orders 1 to `order`, one after another.
Vector100 conditions(const Vector100& unknowns, std::size_t stages, int order);
/// Their derivatives by one-sided differences of width 1e-50, so correct to about 50 digits.
Matrix100 conditions_jacobian(const Vector100& unknowns, std::size_t stages, int order);

}  // namespace kreisel::orders
