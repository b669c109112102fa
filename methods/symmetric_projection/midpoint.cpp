// SPDX-License-Identifier: BSD-3-Clause
//
// The implicit midpoint rule on TG with symmetric projection: from (q~, v~),
//   V = (v~ + v~+)/2,   q~+ = q~ exp(h V),   v~+ = v~ + h f(t + h/2, q~ exp(h V/2), V),
// f = v' of the index-1 form. Without joints it is rkmk/implicit_midpoint.
#include "methods/symmetric_projection/projected_midpoint.hpp"
#include "methods/symmetric_projection/symmetric_projection.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

static std::unique_ptr<ProjectedStep> midpoint_step(System& system, const MotionScale& scale) {
    return std::make_unique<ProjectedMidpoint>(system, scale);
}

KREISEL_METHOD(symmetric_projection(1, midpoint_step),
               {.name = "symmetric_projection/midpoint",
                .order = 2,
                .cites = {"hairer2000", "hairer2006", "munthekaas1998"},
                .summary = "implicit midpoint rule between two equal projections",
                .variable_cost = true,
                .form = Form::implicit,
                .meets_positions = true,
                .meets_velocities = true,
                .preserves = {{Property::symmetric, Domain::autonomous}, {Property::constraints, Domain::autonomous}}});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
