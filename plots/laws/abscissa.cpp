// SPDX-License-Identifier: BSD-3-Clause
#include "plots/laws/abscissa.hpp"

#include <algorithm>

namespace kreisel {

namespace {

std::optional<double> cost_of(const ResultRow& row, const std::string& name) {
    const auto found = row.cost.find(name);
    return found == row.cost.end() ? std::nullopt : std::optional(found->second);
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
    static const std::vector<Abscissa> all = [] {
        std::vector<Abscissa> some = {{"h", "h [s]"}, {"tolerance", "tolerance"}};
        some.insert(some.end(), costs().begin(), costs().end());
        return some;
    }();
    return all;
}

std::string abscissa_label(const std::string& name) {
    const auto& all = abscissae();
    return std::find_if(all.begin(), all.end(), [&](const Abscissa& one) { return one.name == name; })->label;
}

std::optional<double> abscissa_of(const ResultRow& row, const std::string& name) {
    const auto if_positive = [](double value) { return value > 0 ? std::optional(value) : std::nullopt; };
    if (name == "h") { return if_positive(row.h); }
    if (name == "tolerance") { return if_positive(row.tolerance); }
    if (name == "accepted" && !row.adaptive()) { return static_cast<double>(row.steps); }
    return cost_of(row, name == "cpu" ? "run_s" : name);
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
