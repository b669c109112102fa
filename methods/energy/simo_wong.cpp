// SPDX-License-Identifier: BSD-3-Clause
//
// The energy-momentum method of Simo and Wong with the force in the middle of the step.
// Source: [simowong1991, ALGO_C1].
#include "methods/energy/energy_momentum.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

KREISEL_METHOD(energy_momentum(StepForce::midpoint),
               {.name = "energy/simo_wong",
                .order = 2,
                .cites = {"simowong1991"},
                .summary = "energy-momentum method of Simo and Wong, forces in the middle of the step",
                .force_evaluations = 1,
                .variable_cost = true,
                .form = Form::implicit,
                .preserves = {{Property::symmetric, Domain::potential},
                              {Property::momentum, Domain::potential},
                              {Property::energy, Domain::free}}});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
