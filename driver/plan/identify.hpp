// SPDX-License-Identifier: BSD-3-Clause
//
// The names of cells, and what their results say of them.
#pragma once

#include <cstdint>
#include <string>

#include "driver/config/config.hpp"
#include "records/cell/planned.hpp"

namespace kreisel {

/// What results say of the cells of a run, but for hash and steps.
CellIdentity identity_of(const Cell& cell, const ProblemEntry& problem, const std::string& precision,
                         const Order& order);

/// Names the cells of a run by a hash over all that determines their numbers, labels not among it. What they have in
/// common is written out once.
class CellNaming {
  public:
    explicit CellNaming(const PlannedRun& run);
    std::uint64_t name(long steps, double tolerance) const;

  private:
    std::uint64_t before_steps_;
    std::string after_steps_, of_tolerance_, of_times_;
};

}  // namespace kreisel
