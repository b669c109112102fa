// SPDX-License-Identifier: BSD-3-Clause
//
// Whether two descriptions of a motion give the same result.
#pragma once

#include "tests/metamorphic/descriptions/transformation.hpp"
#include "tests/metamorphic/growth/growth.hpp"
#include "tests/metamorphic/models/named_models.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {
namespace metamorphic {

/// Both runs of a comparison; `changed` has been carried back.
struct RunPair {
    Outcome original, changed;
};
RunPair run_both(const Model& model, const Transformed& transformed, const Combination& combination, const Span& span,
                 const Bench& bench = {});

/// The first quantity that differs in a bit, "" if none does.
std::string difference_in_bits(const RunPair& pair, const Model& model);

/// Allowance for round-off of each quantity, in units of C N eps: kappa s of CONTRIBUTING.md.
struct Allowance {
    Real position, rotation, velocity, omega, force, torque;
};
/// From the growth of perturbations. `largest_x` is that of either description, in units of the original; where method
/// or projection solves Phi = 0 (h > 0 is the step), round-off of positions counts as |x|/h in velocities and |x|/h^2
/// in forces.
Allowance allowance(const Model& model, const Sizes& sizes, const Real& largest_x, const growing::Growth& growth,
                    const Real& h);

/// The largest |difference| / (N eps allowance), and its quantity.
struct Excess {
    Real ratio = 0;
    std::string what;
};
Excess excess(const RunPair& pair, const Model& model, const Allowance& allowance, int steps);

/// Joints whose reactions the motion determines: no null vector of C^T has entries in their rows.
std::vector<bool> unique_joints(const Model& model);

/// Largest of |x|, |R|, |v|, |omega| differences, each over its own size.
Real distance(const Outcome& a, const Outcome& b, const Model& model);

}  // namespace metamorphic
}  // namespace KREISEL_PRECISION
}  // namespace kreisel
