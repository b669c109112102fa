// SPDX-License-Identifier: BSD-3-Clause
//
// The Gauss method with 2 stages on TG with symmetric projection: from (q~, v~) the step is that of rkmk/gauss2, the
// symmetrised form of the Munthe-Kaas lift [zanna2001], in coordinates around the middle of the step. Without joints it
// is rkmk/gauss2.
#include "methods/symmetric_projection/projected_gauss.hpp"
#include "methods/symmetric_projection/symmetric_projection.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

static std::unique_ptr<ProjectedStep> gauss2_step(System& system, const MotionScale& scale) {
    return std::make_unique<ProjectedGauss>(system, scale, 2);
}

KREISEL_METHOD(symmetric_projection(2, gauss2_step),
               {.name = "symmetric_projection/gauss2",
                .order = 4,
                .cites = {"hairer2000", "hairer2006", "zanna2001"},
                .summary = "Gauss method with 2 stages between two equal projections",
                .variable_cost = true,
                .form = Form::implicit,
                .meets_positions = true,
                .meets_velocities = true,
                .preserves = {{Property::symmetric, Domain::autonomous}, {Property::constraints, Domain::autonomous}}});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
