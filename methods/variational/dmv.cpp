// SPDX-License-Identifier: BSD-3-Clause
//
// The discrete Moser-Veselov algorithm, of order 2 (methods/variational/moser_veselov.hpp).
// Source: [moserveselov1991]; in quaternions [hairervilmart2006].
#include "methods/variational/moser_veselov.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

KREISEL_METHOD(moser_veselov(0), {.name = "variational/dmv",
                                  .order = 2,
                                  .cites = {"hairervilmart2006", "moserveselov1991"},
                                  .summary = "discrete Moser-Veselov algorithm for free bodies",
                                  .variable_cost = true,
                                  .form = Form::implicit,
                                  .preserves = {{Property::symplectic, Domain::free},
                                                {Property::symmetric, Domain::free},
                                                {Property::momentum, Domain::free},
                                                {Property::energy, Domain::free}},
                                  .formulations = {"SO3", "S3", "SO3xR3", "S3xR3"}});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
