// SPDX-License-Identifier: BSD-3-Clause
//
// Distances of the bodies from the reference at the end.
#include "engine/metrics/metric.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

KREISEL_METRIC({.name = "error.position",
                .unit = "m",
                .symbol = "|x − x_{ref}|",
                .summary = "distance of the final mass centres from the reference, norm over all bodies",
                .level = MetricLevel::configuration,
                .scale = MetricScale::position,
                .place = 1},
               [](const Separation& apart) { return apart.states.position; });

KREISEL_METRIC({.name = "error.rotation",
                .unit = "rad",
                .symbol = "|log(R_{ref}^T R)|",
                .summary = "norm of log(R_ref^T R) at the end, over all bodies",
                .level = MetricLevel::configuration,
                .scale = MetricScale::one,
                .place = 2},
               [](const Separation& apart) { return apart.states.rotation; });

KREISEL_METRIC({.name = "error.velocity",
                .unit = "m/s",
                .symbol = "|v − v_{ref}|",
                .summary = "norm of v - v_ref at the end, over all bodies",
                .level = MetricLevel::velocity,
                .scale = MetricScale::velocity,
                .place = 3},
               [](const Separation& apart) { return apart.states.velocity; });

KREISEL_METRIC({.name = "error.omega",
                .unit = "rad/s",
                .symbol = "|ω − ω_{ref}|",
                .summary = "norm of omega - omega_ref at the end, over all bodies",
                .level = MetricLevel::velocity,
                .scale = MetricScale::omega,
                .place = 4},
               [](const Separation& apart) { return apart.states.omega; });

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
