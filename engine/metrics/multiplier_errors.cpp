// SPDX-License-Identifier: BSD-3-Clause
//
// Distances of the multipliers from those of the reference at the end, forces and torques apart.
#include "engine/metrics/metric.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

KREISEL_METRIC({.name = "error.multipliers",
                .unit = "N",
                .symbol = "|λ − λ_{ref}|",
                .summary = "norm of lambda - lambda_ref at the end, of the rows that are lengths",
                .level = MetricLevel::multipliers,
                .rows = MetricRows::lengths,
                .scale = MetricScale::force,
                .place = 5},
               [](const Separation& apart) { return apart.multipliers.force; });

KREISEL_METRIC({.name = "error.multipliers.torque",
                .unit = "N m",
                .symbol = "|λ − λ_{ref}|",
                .summary = "norm of lambda - lambda_ref at the end, of the rows that compare directions",
                .level = MetricLevel::multipliers,
                .rows = MetricRows::directions,
                .scale = MetricScale::torque,
                .place = 6},
               [](const Separation& apart) { return apart.multipliers.torque; });

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
