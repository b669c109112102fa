// SPDX-License-Identifier: BSD-3-Clause
//
// The energy-momentum method of [simowong1991] on any group, for systems without joints: with p = M v, V = (v + v+)/2,
// u = h V and the force f in the middle of the step,
//   q+ = q exp(u),   p+ = Ad*_{exp(u/2)} (Ad*_{exp(u/2)} p + h f),   Ad*_g = Ad_g^T.
// On SO(3): pi+ - pi = h (torque in space axes). Momentum in space axes changes by the impulse of f alone, and the
// energy by u.f: (v+ - v).M V = u.(Ad*_{exp u} p - p)/h + u.f, where Ad_{exp u} u = u. Symmetric, of order 2. The force
// is
//   midpoint:  f(t + h/2, q exp(u/2), V);
//   gradient:  the same plus the multiple of M u that makes u.f = V(q) - V(q+), a discrete gradient of the potential
//              [gonzalez1996], [celledoni2014]; where there is no potential, the midpoint.
#pragma once

#include "methods/contract/method.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

enum class StepForce { midpoint, gradient };

Factory energy_momentum(StepForce force);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
