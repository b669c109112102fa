// SPDX-License-Identifier: BSD-3-Clause
#include "records/cell_line.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "records/json/writer.hpp"
#include "records/trajectory_file.hpp"
#include "support/hash.hpp"

namespace kreisel {

namespace {

// Unescaped quotes do not occur inside a JSON string, so these can only be members.
constexpr std::string_view status_key = ",\"status\":\"";
constexpr std::string_view cpu_key = ",\"cpu_s\":";
constexpr std::string_view sum_key = ",\"sum\":\"";

std::string metrics_text(const Outcome& outcome, bool quad) {
    ObjectWriter object;
    for (const auto& [name, number] : outcome.metrics) { object.member(name, json_value(number, quad)); }
    return object.text();
}

std::string constraints_text(const ConstraintSummary& constraints, bool quad) {
    ObjectWriter object;
    object.member("rows", fmt::format("{}", constraints.rows)).member("rank", fmt::format("{}", constraints.rank));
    if (constraints.condition) { object.member("condition", json_number(*constraints.condition)); }
    if (constraints.has_redundant_rows()) { object.member("redundant", json_value(constraints.redundant)); }
    if (!constraints.least_norm.empty()) {
        std::string multipliers;
        for (const Number& lambda : constraints.least_norm) {
            multipliers += (multipliers.empty() ? "" : ",") + json_value(lambda, quad);
        }
        object.member("least_norm_multipliers", "[" + multipliers + "]");
    }
    return object.text();
}

// References are computed in quad whatever the cell's precision: their bounds are given as rounded decimals.
std::string reference_text(const Reference& reference, double t_end) {
    ObjectWriter error, object;
    for (const auto& [name, number] : reference.error) { error.member(name, json_number(number.value)); }
    object.member("error", error.text()).member("horizon", json_number(reference.horizon));
    if (t_end > reference.horizon) { object.member("past_horizon", "true"); }
    return object.text();
}

std::string cost_text(const Cost& cost) {
    return ObjectWriter()
        .member("evaluations", fmt::format("{}", cost.evaluations))
        .member("projection_iterations", fmt::format("{}", cost.projection_iterations))
        .member("output_evaluations", fmt::format("{}", cost.output_evaluations))
        .text();
}

bool sum_holds(const std::string& journal_line) {
    const auto sum_at = journal_line.rfind(sum_key);
    if (sum_at == std::string::npos) { return false; }
    const std::string sum = hash_text(std::string_view(journal_line).substr(0, sum_at));
    return std::string_view(journal_line).substr(sum_at) == fmt::format("{}{}\"}}", sum_key, sum);
}

std::string member(std::string_view key, const std::string& json) { return "," + json_text(key) + ":" + json; }

}  // namespace

FinishedCell finished_cell(const PlannedCell& planned, const Outcome& outcome, const Reference* reference,
                           const std::string& trajectory_sum) {
    FinishedCell cell{
        planned.hash, outcome.status, outcome.detail, outcome.t_reached, planned.identity, outcome.cost, ""};
    cell.line += member("status", json_text(outcome.status));
    if (!outcome.detail.empty()) { cell.line += member("detail", json_text(outcome.detail)); }
    if (cell.failed()) {
        cell.line += member("steps_done", fmt::format("{}", outcome.steps_done));
        cell.line += member("t_reached", json_number(outcome.t_reached));
    }
    if (planned.cell.timed && outcome.bodies > 0) { cell.line += member("bodies", fmt::format("{}", outcome.bodies)); }
    if (outcome.final) { cell.line += member("final", json_value(*outcome.final, planned.quad())); }
    if (outcome.constraints.rows > 0) {
        cell.line += member("constraints", constraints_text(outcome.constraints, planned.quad()));
    }
    if (outcome.status != "skipped") { cell.line += member("metrics", metrics_text(outcome, planned.quad())); }
    if (outcome.lost) {
        cell.line += member("lost", ObjectWriter()
                                        .member("integral", json_text(outcome.lost->name))
                                        .member("share", json_number(outcome.lost->share))
                                        .text());
    }
    if (reference != nullptr) { cell.line += member("reference", reference_text(*reference, planned.cell.t_end)); }
    if (!trajectory_sum.empty()) {
        cell.trajectory_sum = trajectory_sum;
        cell.line += member("trajectory", json_text(trajectory_file(planned.hash)));
        cell.line += member("trajectory_sum", json_text(cell.trajectory_sum));
    }
    cell.line += member("cost", cost_text(outcome.cost)) + "}";
    return cell;
}

std::string journal_line(const FinishedCell& cell, const std::string& build) {
    std::string text = cell.line.substr(0, cell.line.size() - 2);  // both braces: cost's and the line's
    text += fmt::format("{}{}", cpu_key, json_number(cell.cost.cpu_s));
    if (cell.cost.step_s) { text += member("step_s", json_number(*cell.cost.step_s)); }
    if (cell.cost.memory) { text += member("memory", json_number(*cell.cost.memory)); }
    text += "}";
    text += member("build", json_text(build));
    return fmt::format("{}{}{}\"}}", text, sum_key, hash_text(text));
}

std::optional<FinishedCell> read_journal_line(const std::string& line, const std::string& build) {
    const auto cpu_at = line.rfind(cpu_key);
    if (cpu_at == std::string::npos || line.find(status_key) == std::string::npos || !sum_holds(line)) {
        return std::nullopt;
    }
    // The check sum is right, so the line is intact.
    const auto value = nlohmann::json::parse(line);
    if (value.at("build") != build) { return std::nullopt; }
    FinishedCell cell;
    cell.hash = value.at("cell");
    cell.status = value.at("status");
    cell.detail = value.value("detail", "");
    cell.t_reached = value.value("t_reached", 0.0);
    const auto& cost = value.at("cost");
    cell.cost.cpu_s = cost.at("cpu_s");
    if (cost.contains("step_s")) { cell.cost.step_s = cost.at("step_s").get<double>(); }
    if (cost.contains("memory")) { cell.cost.memory = cost.at("memory").get<double>(); }
    cell.trajectory_sum = value.value("trajectory_sum", "");
    cell.line = line.substr(0, cpu_at) + "}}";
    return cell;
}

std::optional<std::string> journalled_cell(const std::string& line) {
    if (!sum_holds(line)) { return std::nullopt; }
    return nlohmann::json::parse(line).at("cell");
}

std::string relabelled(const std::string& line, const PlannedCell& planned) {
    return planned.identity + line.substr(line.find(status_key));
}

}  // namespace kreisel
