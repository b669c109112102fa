// SPDX-License-Identifier: BSD-3-Clause
//
// What errors are drawn against: the size of the steps, the tolerance they are chosen to, or what they cost.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "plots/tables/names.hpp"
#include "records/reading/trajectory_table.hpp"

namespace kreisel {

struct Abscissa {
    std::string name;   ///< as a config and a table have it
    std::string label;  ///< with its unit; enhanced text of gnuplot
};

/// h, tolerance, and the costs.
const std::vector<Abscissa>& abscissae();
/// evaluations, exponentials, brackets, newton_iterations, accepted, rejected, cpu.
const std::vector<Abscissa>& costs();
/// Of abscissae().
std::string abscissa_label(const std::string& name);

/// What runs are drawn against over time: t, and the costs.
const std::vector<Abscissa>& times_and_costs();

/// Nothing if the cell does not have it. All steps of one size are accepted.
std::optional<double> abscissa_of(const ResultRow& row, const std::string& name);

/// At each sample of a cell, of times_and_costs(): nothing if it was not measured. CPU time is measured of the whole
/// run and shared out as the solves are, or the steps of a method without solves.
std::optional<std::vector<double>> abscissa_of_samples(const TrajectoryTable& samples, const ResultRow& row,
                                                       const std::string& name);

/// What a cell of a refinement has: x and the value of a metric.
struct WorkPoint {
    double x = 0, error = 0;
    const ResultRow* row = nullptr;
};

/// The points of the cells of a group that are ok and have both; coarsest first.
std::vector<WorkPoint> work_points(const CellGroup& group, const std::string& metric, const std::string& x);

}  // namespace kreisel
