// SPDX-License-Identifier: BSD-3-Clause
//
// The samples of a cell, by column.
#pragma once

#include <string>
#include <vector>

#include "records/results.hpp"

namespace kreisel {

/// A sampled trajectory by column.
struct TrajectoryTable {
    std::vector<std::string> names, units;
    std::vector<std::vector<double>> columns;  ///< NaN where a value is absent

    /// Null where there is no such column.
    const std::vector<double>* find(const std::string& name) const;
    std::string unit(const std::string& name) const;
};

/// trajectories/<cell>.csv in its folder. Throws FileError if it cannot be read or is damaged.
TrajectoryTable read_trajectory(const ResultRow& row);

}  // namespace kreisel
