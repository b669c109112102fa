// SPDX-License-Identifier: BSD-3-Clause
#include "driver/plan/metric_names.hpp"

#include <algorithm>

#include "support/pattern.hpp"

namespace kreisel {

const std::vector<MetricDescription>& common_metrics() {
    static const std::vector<MetricDescription> all = {
        {"error.position", "m", "distance of the final mass centres from the reference, norm over all bodies"},
        {"error.rotation", "rad", "norm of log(R_ref^T R) at the end, over all bodies"},
        {"error.velocity", "m/s", "norm of v - v_ref at the end, over all bodies"},
        {"error.omega", "rad/s", "norm of omega - omega_ref at the end, over all bodies"},
        {"error.multipliers", "N", "norm of lambda - lambda_ref at the end, of the rows that are lengths"},
        {"error.multipliers.torque", "N m", "norm of lambda - lambda_ref at the end, of the rows that compare directions"},
        {"defect.position", "m", "largest |Phi| over all steps, of the rows that are lengths"},
        {"defect.direction", "1", "largest |Phi| over all steps, of the rows that compare directions"},
        {"defect.velocity", "m/s", "largest |d Phi/dt| over all steps, of the rows that are lengths"},
        {"defect.direction.velocity", "1/s", "largest |d Phi/dt| over all steps, of the rows that compare directions"},
        {"defect.acceleration", "m/s^2", "largest |d^2 Phi/dt^2| over all steps, of the rows that are lengths"},
        {"defect.direction.acceleration", "1/s^2",
         "largest |d^2 Phi/dt^2| over all steps, of the rows that compare directions"},
        {"defect.orthogonality", "1", "largest Frobenius norm of R^T R - I over all steps"},
    };
    return all;
}

const std::vector<MetricDescription>& invariant_suffixes() {
    static const std::vector<MetricDescription> all = {
        {"", "as the integral", "largest |I - I0| over all steps"},
        {".final", "as the integral", "|I - I0| at the end"},
        {".relative", "1", "largest |I - I0| / |I0|, where I0 is not zero"},
        {".slope", "as the integral per s", "secular rate: least-squares slope of I - I0 over time"},
        {".slope_error", "as the integral per s", "standard error of that slope"},
    };
    return all;
}

std::vector<std::string> metric_names(const std::vector<std::string>& integrals) {
    std::vector<std::string> names;
    for (const MetricDescription& metric : common_metrics()) {
        names.push_back(metric.name);
        if (metric.name.starts_with("defect.")) { names.push_back(metric.name + ".final"); }
    }
    for (const std::string& integral : integrals) {
        for (const MetricDescription& suffix : invariant_suffixes()) {
            names.push_back("invariant." + integral + suffix.name);
        }
    }
    return names;
}

bool asks_for_errors(const std::vector<std::string>& patterns) {
    const auto names = metric_names({});
    return std::any_of(names.begin(), names.end(), [&](const std::string& name) {
        return name.starts_with("error.") && matches_any(patterns, name);
    });
}

}  // namespace kreisel
