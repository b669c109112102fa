// SPDX-License-Identifier: BSD-3-Clause
#include "records/results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <set>
#include <stdexcept>

#include "records/cell/line.hpp"
#include "records/journal.hpp"
#include "records/json/strict.hpp"
#include "records/json/writer.hpp"
#include "records/kinds/kind.hpp"
#include "records/manifest.hpp"
#include "records/metrics/catalogue.hpp"
#include "support/errors.hpp"
#include "support/files.hpp"

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

// A final size of zero says nothing about the size on the way: one unit is used.
std::map<std::string, double> scales(const ReportedState& final) {
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
        scale[metric.name] = scale[metric.name + largest_of_error] = size->second;
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

bool is_hash(const std::string& text) {
    return !text.empty() && text.find_first_not_of("0123456789abcdefABCDEF") == std::string::npos;
}

std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> parts;
    std::size_t begin = 0;
    for (std::size_t end = text.find(separator); end != std::string::npos; end = text.find(separator, begin)) {
        parts.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    parts.push_back(text.substr(begin));
    return parts;
}

// What differs from run to run is only in the journals.
void add_times(const std::filesystem::path& folder, Results& results) {
    const auto is_timed = [](const ResultRow& row) { return row.bodies > 0; };
    const ExperimentKind* kind = find_experiment_kind(results.kind);
    const bool timed =
        (kind != nullptr && kind->repeated) || std::any_of(results.rows.begin(), results.rows.end(), is_timed);
    if (results.config.empty() || !timed) { return; }
    const JournalContents journals = read_journals(folder, read_manifest(folder / "manifest.json").build);
    results.damage.insert(results.damage.end(), journals.complaints.begin(), journals.complaints.end());
    for (ResultRow& row : results.rows) {
        const auto found = journals.cells.find(row.cell);
        if (found == journals.cells.end()) { continue; }
        const CellTimes& times = found->second.times;
        if (times.step_s) { row.cost["step_s"] = *times.step_s; }
        if (times.memory) { row.cost["memory"] = *times.memory; }
        if (times.run_s) { row.cost["run_s"] = *times.run_s; }
    }
}

void read_manifest_into(const std::filesystem::path& folder, Results& results) {
    const auto file = folder / "manifest.json";
    results.name = folder.filename().string();
    if (!std::filesystem::exists(file)) { return; }
    const nlohmann::json manifest = read_document(file).value;
    if (!manifest.is_object()) { return; }
    if (const auto units = manifest.find("units"); units != manifest.end()) { results.units = *units; }
    const auto config = manifest.find("config");
    if (config == manifest.end() || !config->is_object()) { return; }
    results.config = config->dump(2);
    const auto text = [&](const char* key, const std::string& absent) {
        const auto found = config->find(key);
        return found != config->end() && found->is_string() ? found->get<std::string>() : absent;
    };
    results.kind = text("kind", "");
    results.name = text("name", results.name);
}

std::vector<std::string> measured_metrics(const std::vector<ResultRow>& rows) {
    std::set<std::string> names;
    for (const ResultRow& row : rows) {
        for (const auto& [name, value] : row.metrics) { names.insert(name); }
    }
    return {names.begin(), names.end()};
}

double field(const std::string& text) {
    if (text.empty()) { return std::numeric_limits<double>::quiet_NaN(); }
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (*end != '\0') { throw std::invalid_argument("not a number"); }
    return value;
}

void read_header(const std::string& line, TrajectoryTable& table) {
    for (const std::string& title : split(line, ',')) {
        const auto bracket = title.rfind(" [");
        if (bracket == std::string::npos || title.back() != ']') {
            throw std::invalid_argument("a column has no unit");
        }
        table.names.push_back(title.substr(0, bracket));
        table.units.push_back(title.substr(bracket + 2, title.size() - bracket - 3));
    }
    table.columns.resize(table.names.size());
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
                  .has_trajectory = !outcome.trajectory.empty()};
    for (const auto& [name, number] : outcome.metrics) { row.metrics[name] = number.value; }
    for (const auto& [name, count] : outcome.counts) { row.cost[name] = count.value; }
    if (outcome.final) { row.scale = scales(*outcome.final); }
    if (identity.order) { row.declared_order = declared_orders(*identity.order); }
    row.unmeasured = outcome.unmeasured;
    if (outcome.lost) { row.lost_integral = outcome.lost->name, row.lost_share = outcome.lost->share; }
    if (!outcome.reference) { return row; }
    row.reference_error = outcome.reference->error;
    row.reference_horizon = outcome.reference->horizon;
    row.past_horizon = outcome.reference->past_horizon;
    return row;
}

ResultRow read_result_line(const std::string& line) {
    ResultRow row = result_row(read_record(line));
    if (!is_hash(row.cell)) { throw std::invalid_argument("the cell's name is not a hash"); }
    for (const std::string* told : {&row.formulation, &row.method, &row.projection, &row.precision}) {
        if (told->empty()) { throw std::invalid_argument("it does not say all of what was run"); }
    }
    const bool tells_steps = row.adaptive() || (row.steps > 0 && row.h != 0);
    if (!tells_steps || row.t_end == 0) { throw std::invalid_argument("it does not tell its steps"); }
    return row;
}

Results read_results(const std::filesystem::path& folder) {
    Results results;
    read_manifest_into(folder, results);
    const auto lines = split(read_text(folder / "results.jsonl"), '\n');
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (lines[i].empty()) { continue; }
        try {
            results.rows.push_back(read_result_line(lines[i]));
        } catch (const std::exception& error) {
            results.damage.push_back(fmt::format("results.jsonl:{}: not a result line: {}", i + 1, error.what()));
        }
    }
    add_times(folder, results);
    if (results.units.empty()) { results.units = units_before_format_2(measured_metrics(results.rows)); }
    return results;
}

const std::vector<double>* TrajectoryTable::find(const std::string& name) const {
    const auto at = std::find(names.begin(), names.end(), name);
    return at == names.end() ? nullptr : &columns[static_cast<std::size_t>(at - names.begin())];
}

std::string TrajectoryTable::unit(const std::string& name) const {
    const auto at = std::find(names.begin(), names.end(), name);
    return at == names.end() ? "" : units[static_cast<std::size_t>(at - names.begin())];
}

TrajectoryTable read_trajectory(const std::filesystem::path& folder, const ResultRow& row) {
    const auto file = folder / "trajectories" / (row.cell + ".csv");
    const auto lines = split(read_text(file), '\n');
    TrajectoryTable table;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (lines[i].empty()) { continue; }
        try {
            if (i == 0) {
                read_header(lines[i], table);
                continue;
            }
            const auto fields = split(lines[i], ',');
            if (fields.size() != table.names.size()) { throw std::invalid_argument("wrong number of columns"); }
            for (std::size_t k = 0; k < fields.size(); ++k) { table.columns[k].push_back(field(fields[k])); }
        } catch (const std::exception& error) {
            throw FileError(fmt::format("{}:{}: damaged: {}", file.string(), i + 1, error.what()));
        }
    }
    return table;
}

}  // namespace kreisel
