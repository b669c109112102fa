// SPDX-License-Identifier: BSD-3-Clause
//
// Symmetric projection [hairer2000]: what moves the state onto the constraints after a step leaves them by the same
// multipliers before it, so that a symmetric step Phi_h stays symmetric. On TG, with D(q) = M^{-1} C(q)^T,
//   q^ = q exp(D(q) mu),   v^ = v + D(q) nu,   (q*, v*) = Phi_h(q^, v^),
//   q+ = q* exp(D(q+) mu),   v+ = v* + D(q+) nu,   Phi(t+, q+) = 0,   C(q+) v+ + b = 0.
// An ordinary projection destroys the symmetry, and with it what it is worth over long times.
#pragma once

#include <string>

#include "methods/contract/method.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Of the registered method `base`, which is symmetric, with its default options.
Factory symmetric_projection(const std::string& base);

/// The description of that method, under the name symmetric_projection/SCHEME.
MethodDescription symmetrically_projected(const std::string& scheme, const std::string& base, Order order,
                                          const std::string& source);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
