// SPDX-License-Identifier: BSD-3-Clause
//
// Baumgarte's feedback [baumgarte1972]: accelerations solve
//   [M C^T; C 0] [v'; lambda] = [Q; xi - 2 alpha (C v + b) - beta^2 Phi],
// so that off the constraints Phi'' + 2 alpha Phi' + beta^2 Phi = 0, critically damped where alpha = beta. Rows without
// a position level have no last term. On the constraints the motion is the exact one, which is why a method keeps its
// order; explicit ones are stable only where h times the roots of z^2 + 2 alpha z + beta^2 is small enough.
#pragma once

#include "mechanics/forwarding_system.hpp"
#include "methods/contract/projection.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

struct Feedback {
    Real alpha, beta;  // 1/s, or per step
};

/// `per_step`: alpha and beta are divided by the step size, and are zero outside a step.
std::unique_ptr<System> with_feedback(System& system, const Feedback& feedback, bool per_step);

/// Why the accelerations of a system do not reach a method; empty if they do.
std::string why_no_feedback(const MethodDescription& method);

/// Options `alpha` and `beta`.
std::vector<OptionDescription> feedback_options(const std::string& unit, double alpha, double beta);
Feedback feedback_of(const OptionValues& options);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
