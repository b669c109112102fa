// SPDX-License-Identifier: BSD-3-Clause
#include "driver/plan/text.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>

#include "driver/plan/estimate/estimate.hpp"
#include "records/cell/line.hpp"
#include "records/json/writer.hpp"

namespace kreisel {

namespace {

using Row = std::vector<std::string>;

const Row titles = {"cell", "problem", "formulation", "method", "options", "projection", "precision", "steps", ""};

Row row_of(const PlannedCell& planned) {
    const Cell& cell = planned.run->cell;
    return {planned.hash(),
            planned.label(),
            cell.formulation,
            cell.method,
            options_text(cell.options),
            cell.projection + (cell.projection_options.empty() ? "" : " ") + options_text(cell.projection_options),
            planned.precision(),
            planned.tolerance > 0 ? fmt::format("to {}", planned.tolerance) : fmt::format("{}", planned.steps),
            planned.skip_reason().empty() ? "" : "skipped: " + planned.skip_reason()};
}

void widen(std::vector<std::size_t>& widths, const Row& row) {
    for (std::size_t i = 0; i < row.size(); ++i) { widths[i] = std::max(widths[i], row[i].size()); }
}

void print_row(const Row& row, const std::vector<std::size_t>& widths, std::ostream& out) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) { line += fmt::format("{:<{}}  ", row[i], widths[i]); }
    fmt::print(out, "{}\n", line.substr(0, line.find_last_not_of(' ') + 1));
}

std::string json_of_cell(const PlannedCell& planned) {
    ObjectWriter cell;
    add_identity(planned.identity(), cell);
    if (!planned.skip_reason().empty()) { cell.member("skip_reason", json_text(planned.skip_reason())); }
    if (!planned.reference().empty()) { cell.member("reference", json_text(planned.reference())); }
    return cell.text();
}

}  // namespace

std::string options_text(const OptionValues& options) {
    std::string text;
    for (const auto& [name, value] : options) {
        const auto* word = std::get_if<std::string>(&value);
        text += fmt::format("{}{}={}", text.empty() ? "" : " ", name, word != nullptr ? *word : json_value(value));
    }
    return text;
}

std::string plan_summary(const Plan& plan) {
    const std::size_t skipped = plan.skipped();
    std::string text = fmt::format("{} cell{}: {} to run, {} skipped", plan.cells.size(),
                                   plan.cells.size() == 1 ? "" : "s", plan.cells.size() - skipped, skipped);
    if (!plan.references.empty()) {
        text +=
            fmt::format("; {} reference solution{}", plan.references.size(), plan.references.size() == 1 ? "" : "s");
    }
    return text;
}

// Rows are made twice rather than kept.
void print_plan(const Plan& plan, std::ostream& out) {
    std::vector<std::size_t> widths(titles.size(), 0);
    widen(widths, titles);
    for (const PlannedCell& planned : plan.cells) { widen(widths, row_of(planned)); }
    print_row(titles, widths, out);
    for (const PlannedCell& planned : plan.cells) { print_row(row_of(planned), widths, out); }
    fmt::print(out, "{}; {}\n", plan_summary(plan), estimate_text(estimate_of(plan)));
}

void print_plan_json(const Plan& plan, std::ostream& out) {
    const Estimate estimate = estimate_of(plan);
    ObjectWriter takes;
    takes.member("cpu_s", json_number(estimate.seconds))
        .member("memory", json_number(estimate.memory))
        .member("disk", json_number(estimate.disk));
    fmt::print(out, "{{\"name\":{},\"warnings\":{},\"estimate\":{},\"cells\":[", json_text(plan.config.name),
               json_value(plan.warnings), takes.text());
    for (const PlannedCell& planned : plan.cells) {
        fmt::print(out, "{}\n{}", &planned == &plan.cells.front() ? "" : ",", json_of_cell(planned));
    }
    fmt::print(out, "\n]}}\n");
}

}  // namespace kreisel
