// SPDX-License-Identifier: BSD-3-Clause
#include "plots/tables/scaling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "records/fits/fit.hpp"

namespace kreisel {

namespace {

constexpr long least_bodies = 8;

std::vector<std::string> law_cells(const std::optional<ScalingLaw>& law) {
    if (!law) { return {"-", "-"}; }
    return {fmt::format("{:.3f}", law->exponent), fmt::format("{:.3f}", law->error)};
}

}  // namespace

const std::vector<ScalingQuantity>& scaling_quantities() {
    static const std::vector<ScalingQuantity> all = {
        {"cost.step", "CPU time per step [s]"},
        {"cost.step_per_body", "CPU time per step and body [ns]", 1e-9, true},
        {"cost.memory", "memory [bytes]"},
        {"cost.memory_per_body", "memory per body [kB]", 1e3, true}};
    return all;
}

std::optional<double> scaling_value(const ResultRow& row, const std::string& quantity) {
    const bool time = quantity.starts_with("cost.step");
    const auto found = row.cost.find(time ? "step_s" : "memory");
    if (found == row.cost.end() || row.bodies <= 0) { return std::nullopt; }
    return quantity.ends_with("_per_body") ? found->second / static_cast<double>(row.bodies) : found->second;
}

std::vector<ResultRow> by_series(std::vector<ResultRow> rows) {
    for (ResultRow& row : rows) { row.label = row.series; }
    return rows;
}

std::vector<CellGroup> scaling_curves(const std::vector<ResultRow>& rows) {
    std::vector<CellGroup> curves = grouped(
        rows, [](const ResultRow& a, const ResultRow& b) { return same_but_for_size(a, b) && a.steps == b.steps; });
    for (CellGroup& curve : curves) {
        std::stable_sort(curve.rows.begin(), curve.rows.end(),
                         [](const ResultRow* a, const ResultRow* b) { return a->bodies < b->bodies; });
    }
    return curves;
}

std::optional<ScalingLaw> scaling_law(const CellGroup& curve, const std::string& quantity) {
    std::vector<double> x, y;
    ScalingLaw law;
    int sizes = 0;
    for (const ResultRow* row : curve.rows) {
        const auto value = scaling_value(*row, quantity);
        if (row->bodies < least_bodies || !value || !(*value > 0)) { continue; }
        if (x.empty()) { law.from = row->bodies; }
        if (row->bodies != law.to) { ++sizes; }
        law.to = row->bodies;
        x.push_back(std::log(static_cast<double>(row->bodies)));
        y.push_back(std::log(*value));
    }
    if (sizes < 3) { return std::nullopt; }
    const FittedLine line = fit_line(x, y);
    law.exponent = line.slope;
    law.error = line.slope_error;
    law.coefficient = std::exp(line.intercept);
    return law;
}

TextTable scaling_table(const Results& results, std::string (*number)(double)) {
    const auto rows = by_series(results.rows);
    const CellNames names(rows);
    TextTable table =
        cell_table("scaling", "Time and memory: " + results.name,
                   {"steps", "bodies", "per step [s]", "per step and body [s]", "memory [bytes]", "per body [bytes]"});
    table.notes = {
        "CPU time of a step: that of the fastest of several runs, divided by its steps. Memory: what model, system, "
        "method, projection and state occupy on the heap; differences of a few kB are noise. Both depend on "
        "the machine, the time also on its load."};
    for (const ResultRow& row : rows) {
        if (!row.ok()) { continue; }
        std::vector<std::string> cells = {fmt::format("{}", row.steps), fmt::format("{}", row.bodies)};
        for (const ScalingQuantity& quantity : scaling_quantities()) {
            const auto value = scaling_value(row, quantity.name);
            cells.push_back(value ? number(*value) : "-");
        }
        add_row(table, names, row, cells);
    }
    return table;
}

TextTable scaling_laws_table(const Results& results) {
    const auto rows = by_series(results.rows);
    const CellNames names(rows);
    TextTable table =
        cell_table("scaling_laws", "Growth with the number of bodies N: " + results.name,
                   {"from N", "to N", "exponent of time", "error", "exponent of memory", "error of memory"});
    table.notes = {fmt::format(
        "Time and memory grow like N^exponent: least squares in log-log from {} bodies on, with the standard error.",
        least_bodies)};
    for (const CellGroup& curve : scaling_curves(rows)) {
        const auto time = scaling_law(curve, "cost.step"), memory = scaling_law(curve, "cost.memory");
        if (!time) { continue; }
        std::vector<std::string> cells = {fmt::format("{}", time->from), fmt::format("{}", time->to)};
        for (const auto& law : {time, memory}) {
            for (std::string& cell : law_cells(law)) { cells.push_back(std::move(cell)); }
        }
        add_row(table, names, curve.front(), cells);
    }
    return table;
}

}  // namespace kreisel
