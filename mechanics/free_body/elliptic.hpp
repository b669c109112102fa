// SPDX-License-Identifier: BSD-3-Clause
//
// Elliptic functions and integrals from the complementary modulus k' in [0, 1], which keep their digits at k = 1: the
// library's Jacobi functions take only k, and 1 - k^2 cancels.
#pragma once

#include "lie/real.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// An argument u of the Jacobi functions, am(u) unwrapped, and sn, cn, dn there.
struct EllipticPhase {
    Real u, am, sn, cn, dn;
};

/// At u.
EllipticPhase elliptic_phase(const Real& u, const Real& k1);
/// Where sn : cn = s : c and am(u) is in (-pi, pi], k12 = k'^2: u = F(am, k) by Carlson's R_F.
EllipticPhase elliptic_phase_of(Real s, Real c, const Real& k12);

/// Pi(am u, n, k) for n <= 0: the integral of 1 / (1 - n sn^2) over [0, u]; k2 = k^2, k12 = k'^2.
Real third_kind(const EllipticPhase& phase, const Real& n, const Real& k2, const Real& k12);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
