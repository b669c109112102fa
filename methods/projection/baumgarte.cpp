// SPDX-License-Identifier: BSD-3-Clause
//
// With rates of its own (1/s), whatever the step size. What is usual is alpha = beta, critical damping, from 1/s to
// 10/s [flores2011]; where a motion is fast, 100/s may be little, and where steps are long, 10/s too much.
#include "methods/projection/baumgarte_system.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

KREISEL_PROJECTION(
    {.name = "baumgarte",
     .summary = "no projection: off the constraints Phi'' = -2 alpha Phi' - beta^2 Phi; explicit methods",
     .cites = {"baumgarte1972", "flores2011"},
     .options = feedback_options("1/s", 5, 5)},
    Stabilisation{
        .change = [](System& system,
                     const OptionValues& options) { return with_feedback(system, feedback_of(options), false); },
        .why_not = why_no_feedback});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
