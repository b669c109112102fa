// SPDX-License-Identifier: BSD-3-Clause
//
// The canonical two-form of T*G, left-trivialised.
#pragma once

#include "lie/group.hpp"
#include "lie/linear.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// omega = - d<mu, q^{-1} dq>. On vectors (xi, d) with xi = q^{-1} dq in R^n and d = d mu in R^n, at the momentum mu,
///   omega((xi_1, d_1), (xi_2, d_2)) = d_2 . xi_1 - d_1 . xi_2 + mu . [xi_1, xi_2]
/// [abrahammarsden1978, Prop. 4.4.1]; the matrix of this over the columns of xi and d. `sign` multiplies the last term:
/// 1, but in a test of the sign.
MatX two_form(const Group& group, const VecX& mu, const MatX& xi, const MatX& d, const Real& sign = 1);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
