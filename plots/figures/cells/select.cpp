// SPDX-License-Identifier: BSD-3-Clause
#include "plots/figures/cells/select.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "plots/figures/cells/cell_value.hpp"
#include "plots/tables/names.hpp"
#include "records/reading/trajectory_table.hpp"

namespace kreisel {

namespace {

bool has(const std::vector<std::string>& list, const std::string& value) {
    return std::find(list.begin(), list.end(), value) != list.end();
}

}  // namespace

std::vector<ResultRow> selected_rows(const FigureSpec& spec, const Results& results, bool failed) {
    std::vector<ResultRow> rows;
    const CellNames names(results.rows);
    for (const ResultRow& row : results.rows) {
        const bool chosen = std::all_of(spec.select.begin(), spec.select.end(), [&](const auto& entry) {
            const auto& [key, values] = entry;
            if (key == "steps") { return has(values, fmt::format("{}", row.steps)); }
            if (key == "tolerance") { return has(values, fmt::format("{}", row.tolerance)); }
            if (is_cell_value(key)) {
                const auto value = cell_value(row, key);
                return value && has(values, *value);
            }
            if (key == "problem") {
                return has(values, row.label) || has(values, row.series) || has(values, row.problem);
            }
            return has(values, names.axis(row, key)) || (key == "method" && has(values, row.method)) ||
                   (key == "projection" && has(values, row.projection));
        });
        if (chosen && (row.ok() || (failed && row.status != "skipped"))) { rows.push_back(row); }
    }
    if (rows.empty()) { throw FigureError(fmt::format("{}: no cell that is ok fits \"select\"", spec.name)); }
    return rows;
}

std::vector<ResultRow> with_samples(std::vector<ResultRow> rows, const FigureSpec& spec) {
    std::erase_if(rows, [](const ResultRow& row) { return !row.has_trajectory; });
    if (rows.empty()) {
        throw FigureError(
            fmt::format("{}: the selected cells have no samples; set \"output\": {{\"samples\": K}}", spec.name));
    }
    return rows;
}

ResultRow selected_trajectory(const FigureSpec& spec, const Results& results) {
    const auto rows = with_samples(selected_rows(spec, results), spec);
    if (rows.size() > 1) {
        throw FigureError(
            fmt::format("{}: {} trajectories fit \"select\", this figure draws one", spec.name, rows.size()));
    }
    return rows.front();
}

TrajectoryTable samples_until(std::optional<double> until, const ResultRow& row) {
    TrajectoryTable table = read_trajectory(row);
    const auto* t = table.find("t");
    if (!until || t == nullptr) { return table; }
    // Times are sums of decimals: half a step's rounding must not lose the last sample.
    const double last = *until * (1 + 1e-9);
    const auto count = std::count_if(t->begin(), t->end(), [&](double time) { return time <= last; });
    for (auto& column : table.columns) { column.resize(static_cast<std::size_t>(count)); }
    return table;
}

std::string body_of(const FigureSpec& spec, const std::string& wanted, const TrajectoryTable& trajectory) {
    for (const std::string& name : trajectory.names) {
        if (!name.ends_with(".x1")) { continue; }
        const std::string body = name.substr(0, name.size() - 3);
        if (wanted.empty() || wanted == body) { return body; }
    }
    throw FigureError(fmt::format("{}: the trajectory has no body \"{}\"", spec.name, wanted));
}

}  // namespace kreisel
