// SPDX-License-Identifier: BSD-3-Clause
//
// A basis of the vectors tangent to {Phi(t, q) = 0, C(t, q) v + b(t, q) = 0} at a state y = (q, v).
#pragma once

#include <string>

#include "mechanics/system.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// 2k vectors (xi, w) in the algebra of TG, a column each, where k = n - rank C is the number of degrees of freedom:
///   (xi_a, w_a) with C w_a = - D_xi_a (C v + b), of least kinetic energy, then (0, rate xi_a), a = 1, ..., k,
/// the xi_a an orthonormal basis of the null space of C in the mass metric, xi_a . M xi_b = delta_ab. In them the
/// two-form of T*G has the entries +- rate, and those that M w and the momentum contribute.
struct TangentFrame {
    MatX vectors;              ///< 2 n rows, 2 k columns
    std::string why_not = {};  ///< not empty: there are none, and why
};

/// For holonomic constraints. `rate` of the motion, 1/s.
TangentFrame tangent_frame(System& system, const Real& t, const Real* y, const Real& rate);

/// M X for the columns X, n rows.
MatX times_mass(const System& system, const Real* q, const MatX& X);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
