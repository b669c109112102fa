// SPDX-License-Identifier: BSD-3-Clause
//
// The discrete Moser-Veselov algorithm preprocessed to order 6 (methods/variational/moser_veselov.hpp).
// Source: [hairervilmart2006].
#include "methods/variational/moser_veselov.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

KREISEL_METHOD(moser_veselov(2),
               {.name = "variational/dmv6",
                .order = 6,
                .cites = {"hairervilmart2006", "moserveselov1991"},
                .summary = "discrete Moser-Veselov algorithm for free bodies, preprocessed to order 6",
                .variable_cost = true,
                .form = Form::implicit,
                .preserves = preserved_by_moser_veselov(),
                .formulations = {"SO3", "S3", "SO3xR3", "S3xR3"}});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
