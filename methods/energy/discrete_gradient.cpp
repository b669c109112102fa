// SPDX-License-Identifier: BSD-3-Clause
//
// The energy-momentum method of Simo and Wong with Gonzalez's discrete gradient of the potential as the force. The
// correction of the midpoint force need not be invariant where the potential is, so that momenta are kept on free
// bodies only.
// Source: [gonzalez1996, eq. 3.5], on groups [celledoni2014].
#include "methods/energy/energy_momentum.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

KREISEL_METHOD(energy_momentum(StepForce::gradient),
               {.name = "energy/discrete_gradient",
                .order = 2,
                .cites = {"simowong1991", "gonzalez1996", "celledoni2014"},
                .summary = "energy-momentum method of Simo and Wong, forces a discrete gradient of the potential",
                .force_evaluations = 1,
                .variable_cost = true,
                .form = Form::implicit,
                .preserves = {{Property::symmetric, Domain::potential},
                              {Property::momentum, Domain::free},
                              {Property::energy, Domain::potential}}});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
