// SPDX-License-Identifier: BSD-3-Clause
//
// With rates per step: alpha/h and beta/h. With 1 and sqrt(2), Phi + h Phi' + h^2/2 Phi'' = 0, the Taylor polynomial of
// Phi(t + h) [flores2011]. The equations then change with h, and a method keeps no order for them: stages are
// off the constraints by O(h^2), which the feedback divides by h^2.
#include <cmath>

#include "methods/projection/baumgarte_system.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

static std::string why_no_step_feedback(const MethodDescription& method) {
    if (method.own_control) return method.name + " chooses its steps itself, and feedback per step does not know them";
    return why_no_feedback(method);
}

KREISEL_PROJECTION({.name = "baumgarte_step",
                    .summary = "the feedback of baumgarte with alpha/h and beta/h; orders are lost",
                    .cites = {"baumgarte1972", "flores2011"},
                    .options = feedback_options("per step", 1, sqrt(2.0))},
                   Stabilisation{.change =
                                     [](System& system, const OptionValues& options) {
                                         return with_feedback(system, feedback_of(options), true);
                                     },
                                 .why_not = why_no_step_feedback});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
