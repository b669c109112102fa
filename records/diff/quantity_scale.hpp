// SPDX-License-Identifier: BSD-3-Clause
//
// Sizes of the quantities of a cell, by which the distance of two numbers is judged.
#pragma once

#include <map>
#include <string>

#include "engine/engine.hpp"
#include "records/diff/recorded_cell.hpp"

namespace kreisel {

/// Scales of two records of one cell; each is the larger one of both.
///
/// A number of the final state has that of its family: the largest component of all positions of the cell, of all
/// velocities, of all multipliers that are forces, and so on.
///
/// A metric is a difference with the round-off of the numbers subtracted: near round-off its own size is meaningless.
/// It therefore has the scale of these numbers, or its own size where that is larger: that of its description
/// (MetricScale), and of first integrals
///   invariant.NAME.relative                                1
///   invariant.NAME, .final, .slope, .slope_error           |I0|, over T = t_end for slopes; known by .relative
/// Any other metric, and one whose scale is not recorded, has its own size.
class QuantityScales {
  public:
    QuantityScales(const RecordedCell& a, const RecordedCell& b);

    /// Of a number of the final state of `family`; 0 where all of the family are zero.
    double of_state(const std::string& family) const;
    /// Of the metric `name`, whose larger size is `own`.
    double of_metric(const std::string& name, double own) const;

  private:
    void add(const RecordedCell& cell);
    double of(MetricScale scale) const;
    double of_invariant(const std::string& name) const;

    std::map<std::string, double> of_family_;  ///< largest component of the final state
    std::map<std::string, double> initial_;    ///< |I0| by integral
    double rate_ = 0;                          ///< 1/T
};

}  // namespace kreisel
