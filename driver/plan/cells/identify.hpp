// SPDX-License-Identifier: BSD-3-Clause
//
// The names of cells, and what their results say of them.
#pragma once

#include <cstdint>
#include <string>

#include "records/cell/planned.hpp"

namespace kreisel {

/// What results say of the cells of a run, but for hash, label, parameters and steps.
CellIdentity identity_of(const Cell& cell, const std::string& series, const std::string& precision, const Order& order);

/// Names cells by a hash over all that determines their numbers, labels not among it. What the cells of a run have in
/// common is written out once.
class CellNaming {
  public:
    explicit CellNaming(const PlannedRun& run);
    /// `parameters`: those of its problem, as JSON.
    std::uint64_t name(const std::string& parameters, long steps, double tolerance) const;

  private:
    std::uint64_t before_parameters_;
    std::string before_steps_, after_steps_, of_tolerance_, of_times_;
};

}  // namespace kreisel
