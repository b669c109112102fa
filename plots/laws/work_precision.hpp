// SPDX-License-Identifier: BSD-3-Clause
//
// What an accuracy costs.
#pragma once

#include <optional>
#include <vector>

#include "plots/laws/abscissa.hpp"

namespace kreisel {

/// The accuracies that a table of costs has.
inline constexpr double tabulated_accuracies[] = {1e-3, 1e-6, 1e-9, 1e-12};

struct CostAtAccuracy {
    double cost = 0;
    bool at_most = false;  ///< the cheapest cell is more accurate already: an upper bound
};

/// The lowest cost at which the errors of a refinement fall to `accuracy`: by interpolation of log cost over log error
/// between the first cell, by cost, that is at least as accurate and the one before it. Never extrapolated: nothing
/// where no cell is as accurate, and an upper bound where the cheapest one is more accurate, or where the error leaps
/// to zero. Cells without a cost do not count.
std::optional<CostAtAccuracy> cost_at(std::vector<WorkPoint> points, double accuracy);

}  // namespace kreisel
