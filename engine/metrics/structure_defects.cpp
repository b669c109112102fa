// SPDX-License-Identifier: BSD-3-Clause
//
// What a single step does to the geometry of the motion.
#include "engine/metrics/metric.hpp"
#include "engine/structure/reversal.hpp"
#include "engine/structure/symplecticity.hpp"
#include "engine/structure/volume.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

KREISEL_METRIC({.name = "structure.symplectic",
                .unit = "1",
                .symbol = "|A^T ω_1 A − ω_0|",
                .summary = "by how much a step changes the two-form of T*G, in units of the motion",
                .scale = MetricScale::one,
                .place = 1},
               [](const ObservedStep& at) { return symplecticity_defect(at); });

KREISEL_METRIC({.name = "structure.reversal",
                .unit = "1",
                .symbol = "|Φ_{−h} Φ_h − id|",
                .summary = "distance from the start after a step by h and one by -h, in units of the motion",
                .scale = MetricScale::one,
                .place = 2},
               [](const ObservedStep& at) { return reversal_defect(at); });

KREISEL_METRIC({.name = "structure.volume",
                .unit = "1",
                .symbol = "||det A| − 1|",
                .summary = "by how much a step changes the volume in phase space, relative to it",
                .scale = MetricScale::one,
                .place = 3},
               [](const ObservedStep& at) { return volume_defect(at); });

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
