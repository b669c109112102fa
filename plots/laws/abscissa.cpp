// SPDX-License-Identifier: BSD-3-Clause
#include "plots/laws/abscissa.hpp"

#include <algorithm>

#include "records/reading/trajectory_table.hpp"

namespace kreisel {

namespace {

std::optional<double> cost_of(const ResultRow& row, const std::string& name) {
    const auto found = row.cost.find(name);
    return found == row.cost.end() ? std::nullopt : std::optional(found->second);
}

std::vector<Abscissa> with_costs(std::vector<Abscissa> all) {
    all.insert(all.end(), costs().begin(), costs().end());
    return all;
}

/// The column that CPU time is shared out by; null where there is none.
const std::vector<double>* shares_of_cpu(const TrajectoryTable& samples) {
    for (const char* column : {"cost.evaluations", "cost.accepted"}) {
        const auto* counts = samples.find(column);
        if (counts != nullptr && !counts->empty() && counts->back() > 0) { return counts; }
    }
    return nullptr;
}

bool is_coarser(const WorkPoint& a, const WorkPoint& b) {
    return a.row->adaptive() || b.row->adaptive() ? a.row->tolerance > b.row->tolerance : a.row->steps < b.row->steps;
}

}  // namespace

const std::vector<Abscissa>& costs() {
    static const std::vector<Abscissa> all = {{"evaluations", "solves of the dynamics"},
                                              {"exponentials", "exponentials"},
                                              {"brackets", "brackets"},
                                              {"newton_iterations", "Newton iterations"},
                                              {"accepted", "accepted steps"},
                                              {"rejected", "rejected steps"},
                                              {"cpu", "CPU time [s]"}};
    return all;
}

const std::vector<Abscissa>& abscissae() {
    static const std::vector<Abscissa> all = with_costs({{"h", "h [s]"}, {"tolerance", "tolerance"}});
    return all;
}

const std::vector<Abscissa>& times_and_costs() {
    static const std::vector<Abscissa> all = with_costs({{"t", "t [s]"}});
    return all;
}

std::string abscissa_label(const std::string& name) {
    const auto& all = name == "t" ? times_and_costs() : abscissae();
    return std::find_if(all.begin(), all.end(), [&](const Abscissa& one) { return one.name == name; })->label;
}

std::optional<double> abscissa_of(const ResultRow& row, const std::string& name) {
    const auto if_positive = [](double value) { return value > 0 ? std::optional(value) : std::nullopt; };
    if (name == "h") { return if_positive(row.h); }
    if (name == "tolerance") { return if_positive(row.tolerance); }
    if (name == "accepted" && !row.adaptive()) { return static_cast<double>(row.steps); }
    return cost_of(row, name == "cpu" ? "run_s" : name);
}

std::optional<std::vector<double>> abscissa_of_samples(const TrajectoryTable& samples, const ResultRow& row,
                                                       const std::string& name) {
    const auto* column = name == "cpu" ? shares_of_cpu(samples) : samples.find(name == "t" ? name : "cost." + name);
    if (column == nullptr) { return std::nullopt; }
    std::vector<double> values = *column;
    if (name != "cpu") { return values; }
    const auto run_s = cost_of(row, "run_s");
    if (!run_s) { return std::nullopt; }
    for (double& value : values) { value *= *run_s / column->back(); }
    return values;
}

std::vector<WorkPoint> work_points(const CellGroup& group, const std::string& metric, const std::string& x) {
    std::vector<WorkPoint> points;
    for (const ResultRow* row : group.rows) {
        const auto error = row->metrics.find(metric);
        const auto value = abscissa_of(*row, x);
        if (row->ok() && error != row->metrics.end() && value) { points.push_back({*value, error->second, row}); }
    }
    std::stable_sort(points.begin(), points.end(), is_coarser);
    return points;
}

}  // namespace kreisel
