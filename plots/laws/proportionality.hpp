// SPDX-License-Identifier: BSD-3-Clause
//
// How errors follow the tolerance that steps are chosen to. This is not an order: the step size does not occur in it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "plots/tables/names.hpp"

namespace kreisel {

struct TolerancePoint {
    double tolerance = 0, error = 0;
    double steps = 0;  ///< that were accepted
};

/// error = coefficient tolerance^slope.
struct Proportionality {
    std::optional<double> slope;
    double uncertainty = 0;              ///< standard error of the slope
    double from = 0, to = 0;             ///< the tolerances that were fitted, largest and smallest
    std::vector<TolerancePoint> points;  ///< largest tolerance first
    std::string reason;                  ///< why there is no slope; empty where there is one
};

/// Least-squares slope of log error against log tolerance over all admissible points: those whose error lies below 1e-2
/// of the scale, above 100 times the error of the reference and 100 eps sqrt(N) of the scale, and that took N >= 20
/// steps. At least four points over three decades are needed, none further than a factor of 10 from the line. The
/// scale is that of the cell with the smallest tolerance.
Proportionality proportionality_of(const CellGroup& group, const std::string& metric);

/// Whether the steps of the cells of a group are chosen to tolerances.
inline bool is_adaptive(const CellGroup& group) { return group.front().adaptive(); }

}  // namespace kreisel
