// SPDX-License-Identifier: BSD-3-Clause
#include "driver/plan/text.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include "driver/plan/estimate/estimate.hpp"
#include "records/cell/line.hpp"
#include "records/json/writer.hpp"

namespace kreisel {

namespace {

using Row = std::vector<std::string>;

Row row_of(const PlannedCell& planned) {
    const Cell& cell = planned.cell();
    return {planned.hash(),
            planned.label(),
            cell.formulation,
            cell.method,
            options_text(cell.options),
            cell.projection + (cell.projection_options.empty() ? "" : " ") + options_text(cell.projection_options),
            planned.precision(),
            cell.tolerance > 0 ? fmt::format("to {}", cell.tolerance) : fmt::format("{}", cell.steps),
            planned.skip_reason().empty() ? "" : "skipped: " + planned.skip_reason()};
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

void print_plan(const Plan& plan, std::ostream& out) {
    std::vector<Row> rows = {
        {"cell", "problem", "formulation", "method", "options", "projection", "precision", "steps", ""}};
    for (const PlannedCell& planned : plan.cells) { rows.push_back(row_of(planned)); }
    std::vector<std::size_t> widths(rows.front().size(), 0);
    for (const Row& row : rows) {
        for (std::size_t i = 0; i < row.size(); ++i) { widths[i] = std::max(widths[i], row[i].size()); }
    }
    for (const Row& row : rows) {
        std::string line;
        for (std::size_t i = 0; i < row.size(); ++i) { line += fmt::format("{:<{}}  ", row[i], widths[i]); }
        fmt::print(out, "{}\n", line.substr(0, line.find_last_not_of(' ') + 1));
    }
    fmt::print(out, "{}; {}\n", plan_summary(plan), estimate_text(estimate_of(plan)));
}

void print_plan_json(const Plan& plan, std::ostream& out) {
    std::string cells;
    for (const PlannedCell& planned : plan.cells) {
        ObjectWriter cell;
        add_identity(planned.identity(), cell);
        if (!planned.skip_reason().empty()) { cell.member("skip_reason", json_text(planned.skip_reason())); }
        if (!planned.reference().empty()) { cell.member("reference", json_text(planned.reference())); }
        cells += (cells.empty() ? "\n" : ",\n") + cell.text();
    }
    const Estimate estimate = estimate_of(plan);
    ObjectWriter takes;
    takes.member("cpu_s", json_number(estimate.seconds))
        .member("memory", json_number(estimate.memory))
        .member("disk", json_number(estimate.disk));
    fmt::print(out, "{{\"name\":{},\"warnings\":{},\"estimate\":{},\"cells\":[{}\n]}}\n", json_text(plan.config.name),
               json_value(plan.warnings), takes.text(), cells);
}

}  // namespace kreisel
