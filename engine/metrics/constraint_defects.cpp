// SPDX-License-Identifier: BSD-3-Clause
//
// Norms of what the constraints want to be zero, on three levels; lengths and comparisons of directions apart.
#include "engine/metrics/metric.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

KREISEL_METRIC({.name = "defect.position",
                .unit = "m",
                .symbol = "max |Φ|",
                .summary = "largest |Phi| over all steps, of the rows that are lengths",
                .rows = MetricRows::lengths,
                .scale = MetricScale::position,
                .place = 1},
               [](Observation& now) { return now.norm(RowLevel::position, false); });

KREISEL_METRIC({.name = "defect.direction",
                .unit = "1",
                .symbol = "max |Φ|, directions",
                .summary = "largest |Phi| over all steps, of the rows that compare directions",
                .rows = MetricRows::directions,
                .scale = MetricScale::one,
                .place = 2},
               [](Observation& now) { return now.norm(RowLevel::position, true); });

KREISEL_METRIC({.name = "defect.velocity",
                .unit = "m/s",
                .symbol = "max |dΦ/dt|",
                .summary = "largest |d Phi/dt| over all steps, of the rows that are lengths",
                .rows = MetricRows::lengths,
                .scale = MetricScale::velocity,
                .place = 3},
               [](Observation& now) { return now.norm(RowLevel::velocity, false); });

KREISEL_METRIC({.name = "defect.direction.velocity",
                .unit = "1/s",
                .symbol = "max |dΦ/dt|, directions",
                .summary = "largest |d Phi/dt| over all steps, of the rows that compare directions",
                .rows = MetricRows::directions,
                .scale = MetricScale::omega,
                .place = 4},
               [](Observation& now) { return now.norm(RowLevel::velocity, true); });

KREISEL_METRIC({.name = "defect.acceleration",
                .unit = "m/s^2",
                .symbol = "max |d^2Φ/dt^2|",
                .summary = "largest |d^2 Phi/dt^2| over all steps, of the rows that are lengths",
                .rows = MetricRows::lengths,
                .scale = MetricScale::acceleration,
                .place = 5},
               [](Observation& now) { return now.norm(RowLevel::acceleration, false); });

KREISEL_METRIC({.name = "defect.direction.acceleration",
                .unit = "1/s^2",
                .symbol = "max |d^2Φ/dt^2|, directions",
                .summary = "largest |d^2 Phi/dt^2| over all steps, of the rows that compare directions",
                .rows = MetricRows::directions,
                .scale = MetricScale::angular_acceleration,
                .place = 6},
               [](Observation& now) { return now.norm(RowLevel::acceleration, true); });

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
