// SPDX-License-Identifier: BSD-3-Clause
//
// Symmetric methods on TG with symmetric projection [hairer2000], [hairer2006, V.4.1]: a projection before the step and
// one after it by the same multipliers, which restores the symmetry that a projection after the step destroys. With
// G = M^{-1} C^T,
//   q~ = q exp(h G(q) mu),   v~ = v + G(q) nu,
//   a step of the method from (q~, v~) to (q~+, v~+),
//   q+ = q~+ exp(h G(q+) mu),   v+ = v~+ + G(q+) nu,
// with mu and nu such that Phi(t+, q+) = 0 and C(t+, q+) v+ + b(t+, q+) = 0. Exchanging the ends, h by -h and nu by -nu
// gives the same equations: the method is symmetric. The cited papers have C^T for G. For a method of order p, mu is
// O(h^p) and nu O(h^(p + 1)), so that the order stays p. Without joints the step is that of the method.
#pragma once

#include <functional>
#include <memory>

#include "methods/contract/method.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

class ProjectedStep;
class MotionScale;

using MakeProjectedStep = std::function<std::unique_ptr<ProjectedStep>(System&, const MotionScale&)>;

/// `make` makes the equations of a step of the method (projected_step.hpp), which has this many implicit stages.
Factory symmetric_projection(int stages, MakeProjectedStep make);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
