// SPDX-License-Identifier: BSD-3-Clause
//
// The metrics that every problem has: one line each. Lists, checks of a config, units, axis labels, tables and the
// orders that are declared for them follow from here; engine/run.cpp and engine/metrics measure them. Those of first
// integrals, invariant.<integral>, are not in the table: a system names its integrals itself.
#pragma once

#include <array>
#include <string_view>

namespace kreisel {

/// Which of the declared orders (methods/contract/description.hpp) an error is held against.
enum class MetricLevel { none, configuration, velocity, multipliers };

/// The constraint rows that a metric is made of: all the same whether there are any, lengths, or comparisons of
/// directions.
enum class MetricRows { any, lengths, directions };

struct MetricDescription {
    std::string_view name, unit;
    std::string_view symbol;  ///< in gnuplot's enhanced notation
    std::string_view summary;
    MetricLevel level = MetricLevel::none;
    MetricRows rows = MetricRows::any;
};

inline constexpr auto metric_table = std::to_array<MetricDescription>({
    {"error.position", "m", "|x − x_{ref}|",
     "distance of the final mass centres from the reference, norm over all bodies", MetricLevel::configuration},
    {"error.rotation", "rad", "|log(R_{ref}^T R)|", "norm of log(R_ref^T R) at the end, over all bodies",
     MetricLevel::configuration},
    {"error.velocity", "m/s", "|v − v_{ref}|", "norm of v - v_ref at the end, over all bodies", MetricLevel::velocity},
    {"error.omega", "rad/s", "|ω − ω_{ref}|", "norm of omega - omega_ref at the end, over all bodies",
     MetricLevel::velocity},
    {"error.multipliers", "N", "|λ − λ_{ref}|", "norm of lambda - lambda_ref at the end, of the rows that are lengths",
     MetricLevel::multipliers, MetricRows::lengths},
    {"error.multipliers.torque", "N m", "|λ − λ_{ref}|",
     "norm of lambda - lambda_ref at the end, of the rows that compare directions", MetricLevel::multipliers,
     MetricRows::directions},
    {"defect.position", "m", "max |Φ|", "largest |Phi| over all steps, of the rows that are lengths", MetricLevel::none,
     MetricRows::lengths},
    {"defect.direction", "1", "max |Φ|, directions",
     "largest |Phi| over all steps, of the rows that compare directions", MetricLevel::none, MetricRows::directions},
    {"defect.velocity", "m/s", "max |dΦ/dt|", "largest |d Phi/dt| over all steps, of the rows that are lengths",
     MetricLevel::none, MetricRows::lengths},
    {"defect.direction.velocity", "1/s", "max |dΦ/dt|, directions",
     "largest |d Phi/dt| over all steps, of the rows that compare directions", MetricLevel::none,
     MetricRows::directions},
    {"defect.acceleration", "m/s^2", "max |d^2Φ/dt^2|",
     "largest |d^2 Phi/dt^2| over all steps, of the rows that are lengths", MetricLevel::none, MetricRows::lengths},
    {"defect.direction.acceleration", "1/s^2", "max |d^2Φ/dt^2|, directions",
     "largest |d^2 Phi/dt^2| over all steps, of the rows that compare directions", MetricLevel::none,
     MetricRows::directions},
    {"defect.orthogonality", "1", "max |R^T R − I|", "largest Frobenius norm of R^T R - I over all steps"},
});

/// A deviation from the constraints or the group, largest over all steps; "NAME.final" is the one at the end.
constexpr bool is_defect(const MetricDescription& metric) { return metric.name.starts_with("defect."); }
/// A distance from the reference at the end.
constexpr bool is_error(const MetricDescription& metric) { return metric.name.starts_with("error."); }

/// The entry of a name, with or without ".final" or ".max"; null where the table has none.
constexpr const MetricDescription* find_metric(std::string_view name) {
    for (const std::string_view suffix : {".final", ".max"})
        if (name.ends_with(suffix)) name.remove_suffix(suffix.size());
    for (const MetricDescription& metric : metric_table)
        if (metric.name == name) return &metric;
    return nullptr;
}

/// One error of a level, for what holds for all of them.
constexpr std::string_view metric_of(MetricLevel level) {
    for (const MetricDescription& metric : metric_table)
        if (metric.level == level) return metric.name;
    return "";
}

}  // namespace kreisel
