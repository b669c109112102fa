// SPDX-License-Identifier: BSD-3-Clause
#include "plots/tables/drift.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "records/fits/order.hpp"

namespace kreisel {

namespace {

double metric(const ResultRow& row, const std::string& name) { return value_or_nan(row.metrics, name); }

std::vector<std::string> growth_cells(const std::optional<GrowthLaw>& growth) {
    if (!growth) { return {"-", "-", "-"}; }
    return {fmt::format("{:.2f}", growth->exponent), fmt::format("{:.2f}", growth->spread),
            fmt::format("{:.4g}–{:.4g}", growth->from, growth->to)};
}

// max |omega| |v| over all samples and bodies: the size of the accelerations of a body that rotates about a joint.
double largest_acceleration(const TrajectoryTable& trajectory) {
    const auto norm = [&](const std::string& name, std::size_t sample) {
        double sum = 0;
        for (const char* component : {"1", "2", "3"}) {
            const auto* column = trajectory.find(name + component);
            if (column == nullptr) { return 0.0; }
            sum += (*column)[sample] * (*column)[sample];
        }
        return std::sqrt(sum);
    };
    double largest = 0;
    for (const std::string& column : trajectory.names) {
        if (!column.ends_with(".x1")) { continue; }
        const std::string body = column.substr(0, column.size() - 2);
        const std::size_t samples = trajectory.columns.front().size();
        for (std::size_t i = 0; i < samples; ++i) {
            largest = std::max(largest, norm(body + "omega", i) * norm(body + "v", i));
        }
    }
    return largest;
}

}  // namespace

double roundoff_level(const TrajectoryTable& trajectory, const std::string& precision) {
    const auto* t = trajectory.find("t");
    const double end = t == nullptr || t->empty() ? 0 : t->back();
    return epsilon_of(precision) * std::max(1e4, 10 * largest_acceleration(trajectory) * end * end / 2);
}

std::optional<GrowthLaw> growth_of(const TrajectoryTable& trajectory, const std::string& name,
                                   const std::string& precision) {
    const auto* t = trajectory.find("t");
    const auto* y = trajectory.find(name + ".max");
    if (t == nullptr || y == nullptr) { return std::nullopt; }
    return fit_growth(*t, *y, roundoff_level(trajectory, precision));
}

std::vector<std::string> plain_metrics(const std::vector<ResultRow>& rows, const std::string& prefix) {
    std::vector<std::string> found;
    for (const ResultRow& row : rows) {
        for (const auto& [name, value] : row.metrics) {
            const bool plain = name.starts_with(prefix) && name.find('.', prefix.size()) == std::string::npos;
            if (plain && std::find(found.begin(), found.end(), name) == found.end()) { found.push_back(name); }
        }
    }
    return found;
}

TextTable drift_table(const Results& results, const std::filesystem::path& folder, std::string (*number)(double)) {
    const CellNames names(results.rows);
    TextTable table = cell_table("drift", "Constraint and orthogonality defects: " + results.name,
                                 {"steps", "h [s]", "defect", "maximum", "final", "exponent", "spread", "range [s]"});
    table.notes = {
        "Growth law: the running maximum of the defect grows like t^exponent over the given range of t (least squares "
        "in log-log over the last two octaves); spread: largest distance of an octave's own exponent from it. None is "
        "given for round-off, or where the octaves differ by more than 1/2."};
    const auto metrics = plain_metrics(results.rows, "defect.");
    for (const ResultRow& row : results.rows) {
        if (row.status == "skipped") { continue; }
        const auto trajectory = row.has_trajectory ? read_trajectory(folder, row) : TrajectoryTable{};
        for (const std::string& name : metrics) {
            if (!row.metrics.contains(name)) { continue; }
            std::vector<std::string> cells = {fmt::format("{}", row.steps), number(row.h), name.substr(7),
                                              number(metric(row, name)), number(metric(row, name + ".final"))};
            for (std::string& cell : growth_cells(growth_of(trajectory, name, row.precision))) {
                cells.push_back(std::move(cell));
            }
            add_row(table, names, row, cells);
        }
    }
    return table;
}

TextTable invariants_table(const Results& results, std::string (*number)(double)) {
    const CellNames names(results.rows);
    TextTable table = cell_table("invariants", "First integrals: " + results.name,
                                 {"steps", "h [s]", "integral", "maximum", "relative", "slope [1/s]", "slope error"});
    table.notes = {
        "Largest |I - I0| and |I - I0|/|I0| over all steps; slope: least-squares secular rate of I - I0, in the "
        "unit of the integral per second, with its standard error."};
    for (const ResultRow& row : results.rows) {
        if (row.status == "skipped") { continue; }
        for (const std::string& name : plain_metrics({row}, "invariant.")) {
            add_row(table, names, row,
                    {fmt::format("{}", row.steps), number(row.h), name.substr(10), number(metric(row, name)),
                     number(metric(row, name + ".relative")), number(metric(row, name + ".slope")),
                     number(metric(row, name + ".slope_error"))});
        }
    }
    return table;
}

TextTable cost_table(const Results& results) {
    const CellNames names(results.rows);
    TextTable table = cell_table("cost", "Cost: " + results.name,
                                 {"steps", "evaluations", "per step", "projection iterations", "iterations per step"});
    table.notes = {
        "Evaluations are solves of the dynamics inside the steps; those of start, projection and output are "
        "counted apart."};
    for (const ResultRow& row : results.rows) {
        if (!row.ok() || !row.cost.contains("evaluations")) { continue; }
        const double evaluations = row.cost.at("evaluations");
        const auto found = row.cost.find("projection_iterations");
        const double iterations = found == row.cost.end() ? 0 : found->second;
        const auto steps = static_cast<double>(row.steps);
        add_row(
            table, names, row,
            {fmt::format("{}", row.steps), fmt::format("{}", evaluations), fmt::format("{:.3g}", evaluations / steps),
             fmt::format("{}", iterations), fmt::format("{:.3g}", iterations / steps)});
    }
    return table;
}

TextTable failures_table(const Results& results) {
    const CellNames names(results.rows);
    TextTable table = cell_table("not_ok", "Cells failed or skipped: " + results.name, {"steps", "status", "reason"});
    for (const ResultRow& row : results.rows) {
        if (!row.ok()) { add_row(table, names, row, {fmt::format("{}", row.steps), row.status, row.detail}); }
    }
    return table;
}

}  // namespace kreisel
