// SPDX-License-Identifier: BSD-3-Clause
#include "records/results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <stdexcept>

#include "engine/metric_table.hpp"
#include "records/journal.hpp"
#include "records/json/strict.hpp"
#include "records/manifest.hpp"
#include "support/errors.hpp"
#include "support/files.hpp"

namespace kreisel {

namespace {

using nlohmann::json;

// A number, or a decimal string (quad).
double number(const json& value) {
    if (value.is_number()) { return value.get<double>(); }
    const auto& text = value.get_ref<const std::string&>();
    char* end = nullptr;
    const double result = std::strtod(text.c_str(), &end);
    if (text.empty() || *end != '\0' || !std::isfinite(result)) { throw std::invalid_argument("not a number"); }
    return result;
}

std::map<std::string, double> numbers(const json& line, const char* key) {
    std::map<std::string, double> result;
    if (!line.contains(key)) { return result; }
    for (const auto& [name, value] : line.at(key).items()) { result[name] = number(value); }
    return result;
}

std::map<std::string, std::string> texts(const json& line, const char* key) {
    std::map<std::string, std::string> result;
    if (!line.contains(key)) { return result; }
    for (const auto& [name, value] : line.at(key).items()) {
        result[name] = value.is_string() ? value.get<std::string>() : value.dump();
    }
    return result;
}

double norm(const json& list) {
    double sum = 0;
    for (const json& entry : list) { sum += number(entry) * number(entry); }
    return std::sqrt(sum);
}

double norm_over_bodies(const json& final, const char* key) {
    double sum = 0;
    for (const json& body : final.at("bodies")) { sum += std::pow(norm(body.at(key)), 2); }
    return std::sqrt(sum);
}

// A final size of zero says nothing about the size on the way: one unit is used.
std::map<std::string, double> scales(const json& final) {
    const auto or_one = [](double size) { return size > 0 ? size : 1; };
    std::map<std::string, double> scale = {{"error.position", or_one(norm_over_bodies(final, "x"))},
                                           {"error.rotation", 1},
                                           {"error.velocity", or_one(norm_over_bodies(final, "v"))},
                                           {"error.omega", or_one(norm_over_bodies(final, "omega"))}};
    if (!final.contains("multipliers")) { return scale; }
    const json names = final.value("multiplier_names", json::array());
    json forces = json::array(), torques = json::array();
    for (std::size_t i = 0; i < final.at("multipliers").size(); ++i) {
        const bool torque = i < names.size() && names[i].get<std::string>().ends_with("[N m]");
        (torque ? torques : forces).push_back(final.at("multipliers")[i]);
    }
    if (!forces.empty()) { scale["error.multipliers"] = or_one(norm(forces)); }
    if (!torques.empty()) { scale["error.multipliers.torque"] = or_one(norm(torques)); }
    return scale;
}

std::map<std::string, int> declared_orders(const json& order) {
    const std::map<MetricLevel, int> levels = {{MetricLevel::configuration, order.at("configuration")},
                                               {MetricLevel::velocity, order.at("velocity")},
                                               {MetricLevel::multipliers, order.at("multipliers")}};
    std::map<std::string, int> orders;
    for (const MetricDescription& metric : metric_table) {
        if (const auto level = levels.find(metric.level); level != levels.end()) {
            orders.emplace(metric.name, level->second);
        }
    }
    return orders;
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
    const bool timed = std::any_of(results.rows.begin(), results.rows.end(), is_timed);
    if (!results.config.is_object() || !timed) { return; }
    const JournalContents journals = read_journals(folder, read_manifest(folder / "manifest.json").build);
    results.damage.insert(results.damage.end(), journals.complaints.begin(), journals.complaints.end());
    for (ResultRow& row : results.rows) {
        const auto found = journals.cells.find(row.cell);
        if (found == journals.cells.end()) { continue; }
        const Cost& cost = found->second.cost;
        if (cost.step_s) { row.cost["step_s"] = *cost.step_s; }
        if (cost.memory) { row.cost["memory"] = *cost.memory; }
    }
}

void read_manifest_into(const std::filesystem::path& folder, Results& results) {
    const auto file = folder / "manifest.json";
    results.name = folder.filename().string();
    if (!std::filesystem::exists(file)) { return; }
    const json manifest = read_document(file).value;
    if (manifest.is_object() && manifest.contains("config")) { results.config = manifest["config"]; }
    if (results.config.is_object() && results.config.contains("name") && results.config["name"].is_string()) {
        results.name = results.config["name"];
    }
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

ResultRow read_result_line(const std::string& text) {
    const json line = json::parse(text);
    ResultRow row;
    row.cell = line.at("cell");
    if (!is_hash(row.cell)) { throw std::invalid_argument("the cell's name is not a hash"); }
    row.problem = line.at("problem");
    row.label = line.value("label", row.problem);
    if (row.label.empty()) { row.label = row.problem; }
    row.series = line.value("series", row.label);
    row.parameters = line.value("parameters", json::object());
    row.formulation = line.at("formulation");
    row.method = line.at("method");
    row.options = texts(line, "options");
    row.projection = line.at("projection");
    row.projection_options = texts(line, "projection_options");
    row.precision = line.at("precision");
    row.steps = line.at("steps");
    row.bodies = line.value("bodies", 0L);
    row.h = number(line.at("h"));
    row.t_end = number(line.at("t_end"));
    row.status = line.at("status");
    row.detail = line.value("detail", "");
    row.t_reached = line.contains("t_reached") ? number(line.at("t_reached")) : 0;
    row.metrics = numbers(line, "metrics");
    row.cost = numbers(line, "cost");
    if (line.contains("reference")) {
        row.reference_error = numbers(line.at("reference"), "error");
        row.reference_horizon = number(line.at("reference").at("horizon"));
        row.past_horizon = line.at("reference").value("past_horizon", false);
    }
    if (line.contains("lost")) {
        row.lost_integral = line.at("lost").at("integral");
        row.lost_share = number(line.at("lost").at("share"));
    }
    if (line.contains("final")) { row.scale = scales(line.at("final")); }
    if (line.contains("order")) { row.declared_order = declared_orders(line.at("order")); }
    row.has_trajectory = line.contains("trajectory");
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
