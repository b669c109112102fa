// SPDX-License-Identifier: BSD-3-Clause
#include "records/results.hpp"

#include <cmath>
#include <stdexcept>

#include "records/cell/line.hpp"
#include "records/json/writer.hpp"
#include "records/metrics/catalogue.hpp"

namespace kreisel {

namespace {

template <class Numbers>
double norm(const Numbers& numbers) {
    double sum = 0;
    for (const Number& number : numbers) { sum += number.value * number.value; }
    return std::sqrt(sum);
}

double norm_over_bodies(const ReportedState& final, std::array<Number, 3> ReportedBody::*part) {
    double sum = 0;
    for (const ReportedBody& body : final.bodies) { sum += std::pow(norm(body.*part), 2); }
    return std::sqrt(sum);
}

// Of the errors that are known. A final size of zero says nothing about the size on the way: one unit is used.
template <class IsKnown>
std::map<std::string, double> scales(const ReportedState& final, const IsKnown& is_known) {
    const auto or_one = [](double size) { return size > 0 ? size : 1; };
    std::vector<Number> forces, torques;
    for (std::size_t i = 0; i < final.multipliers.size(); ++i) {
        const bool torque = i < final.multiplier_names.size() && final.multiplier_names[i].ends_with("[N m]");
        (torque ? torques : forces).push_back(final.multipliers[i]);
    }
    std::map<MetricScale, double> sizes = {{MetricScale::one, 1},
                                           {MetricScale::position, or_one(norm_over_bodies(final, &ReportedBody::x))},
                                           {MetricScale::velocity, or_one(norm_over_bodies(final, &ReportedBody::v))},
                                           {MetricScale::omega, or_one(norm_over_bodies(final, &ReportedBody::omega))}};
    if (!forces.empty()) { sizes[MetricScale::force] = or_one(norm(forces)); }
    if (!torques.empty()) { sizes[MetricScale::torque] = or_one(norm(torques)); }
    std::map<std::string, double> scale;
    for (const MetricDescription& metric : metric_catalogue()) {
        const auto size = sizes.find(metric.scale);
        if (!is_error(metric) || size == sizes.end()) { continue; }
        for (const std::string& name : {metric.name, metric.name + largest_of_error}) {
            if (is_known(name)) { scale[name] = size->second; }
        }
    }
    return scale;
}

std::map<std::string, int> declared_orders(const Order& order) {
    const std::map<MetricLevel, int> levels = {{MetricLevel::configuration, order.configuration},
                                               {MetricLevel::velocity, order.velocity},
                                               {MetricLevel::multipliers, order.multipliers}};
    std::map<std::string, int> orders;
    for (const MetricDescription& metric : metric_catalogue()) {
        if (const auto level = levels.find(metric.level); level != levels.end()) {
            orders.emplace(metric.name, level->second);
            orders.emplace(metric.name + largest_of_error, level->second);
        }
    }
    return orders;
}

std::map<std::string, std::string> texts(const OptionValues& options) {
    std::map<std::string, std::string> result;
    for (const auto& [name, value] : options) {
        const auto* word = std::get_if<std::string>(&value);
        result[name] = word != nullptr ? *word : json_value(value);
    }
    return result;
}

std::map<std::string, double> values(const std::vector<std::pair<std::string, Number>>& numbers) {
    std::map<std::string, double> result;
    for (const auto& [name, number] : numbers) { result[name] = number.value; }
    return result;
}

std::map<std::string, std::string> digits(const std::vector<std::pair<std::string, Number>>& numbers) {
    std::map<std::string, std::string> result;
    for (const auto& [name, number] : numbers) { result[name] = number.text; }
    return result;
}

}  // namespace

ResultRow result_row(const CellRecord& record) {
    const CellIdentity& identity = record.identity;
    const CellOutcome& outcome = record.outcome;
    ResultRow row{.cell = identity.cell,
                  .problem = identity.problem,
                  .series = identity.series,
                  .label = identity.label,
                  .formulation = identity.formulation,
                  .method = identity.method,
                  .projection = identity.projection,
                  .precision = identity.precision,
                  .status = outcome.status,
                  .detail = outcome.detail,
                  .options = texts(identity.options),
                  .projection_options = texts(identity.projection_options),
                  .parameters = identity.parameters,
                  .steps = identity.steps,
                  .bodies = outcome.bodies,
                  .h = identity.h,
                  .tolerance = identity.tolerance,
                  .t_end = identity.t_end,
                  .controller = identity.controller,
                  .t_reached = outcome.t_reached,
                  .has_trajectory = !outcome.trajectory.empty(),
                  .trajectory_sum = outcome.trajectory_sum};
    row.metrics = values(outcome.metrics);
    if (identity.quad()) { row.digits = digits(outcome.metrics); }
    row.cost = values(outcome.counts);
    if (identity.order) { row.declared_order = declared_orders(*identity.order); }
    row.unmeasured = outcome.unmeasured;
    if (outcome.lost) { row.lost_integral = outcome.lost->name, row.lost_share = outcome.lost->share; }
    if (outcome.reference) {
        row.reference_error = outcome.reference->error;
        row.reference_horizon = outcome.reference->horizon;
        row.past_horizon = outcome.reference->past_horizon;
    }
    if (outcome.final) {
        row.scale = scales(*outcome.final, [&](const std::string& name) {
            return row.metrics.contains(name) || row.reference_error.contains(name);
        });
    }
    return row;
}

ResultRow read_result_line(const std::string& line) {
    ResultRow row = result_row(read_record(line));
    if (!is_cell_name(row.cell)) { throw std::invalid_argument("the cell's name is not a hash"); }
    for (const std::string* told : {&row.formulation, &row.method, &row.projection, &row.precision}) {
        if (told->empty()) { throw std::invalid_argument("it does not say all of what was run"); }
    }
    const bool tells_steps = row.adaptive() || (row.steps > 0 && row.h != 0);
    if (!tells_steps || row.t_end == 0) { throw std::invalid_argument("it does not tell its steps"); }
    return row;
}

}  // namespace kreisel
