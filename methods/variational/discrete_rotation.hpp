// SPDX-License-Identifier: BSD-3-Clause
//
// The free rotation of a body within a step by a discrete variational principle: R -> R tau(u) and the momentum p -> p+
// in body axes, with R+ p+ = R p. What differs is the distance by which the kinetic energy is measured,
//   exp:     h p = (dexp^{-1}_u)^T J u = J u + u x J u/2 + cotc(u^2) u x (u x J u),
//   cayley:  h p = (dcay^{-1}_u)^T J u = J u + u x J u/2 + (u.J u) u/4       [bourabeemarsden2009],
//   matrix:  (1 + u^2/4) h p = J u + u x J u/2, tau = cay: with F = cay(u) and J_d = tr(J)/2 - J, that is
//            h p^ = F J_d - J_d F^T, the discrete Moser-Veselov algorithm [moserveselov1991], [leeleokmcclamroch2007],
// and h (p+ - p) = - u x J u, over 1 + u^2/4 for `matrix`.
#pragma once

#include "lie/linear.hpp"
#include "lie/status.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

enum class RotationDistance { exp, cayley, matrix };

class DiscreteRotation {
  public:
    /// Of a body with the inertia J and the momentum p.
    DiscreteRotation(RotationDistance distance, const Mat3& J, const Mat3& J_inverse, const Vec3& p, const Real& h);

    /// Newton's method from u = h J^{-1} p, down to round-off; `newton_failed` where the step is too long.
    Status solve(long& iterations);
    const Vec3& increment() const { return u_; }  ///< u
    Vec3 gained_momentum() const;                 ///< p+ - p

  private:
    /// r_ and slope_ at u_; false outside the chart.
    bool evaluate();

    RotationDistance distance_;
    const Mat3& J_;
    Real h_;
    Vec3 hp_, u_, m_, r_;  // m = J u
    Mat3 slope_;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
