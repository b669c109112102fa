// SPDX-License-Identifier: BSD-3-Clause
//
// How the cells of a plan are dealt to the parts of a run. The deal follows from the plan and the estimated cost of its
// cells (cost.hpp) alone, so that machines that know nothing of each other agree on it.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "driver/plan/plan.hpp"

namespace kreisel {

/// The cells of the I-th of N parts, by index, in the order of the plan. Every cell is in one part.
std::vector<std::size_t> cells_of_shard(const Plan& plan, std::size_t shard, std::size_t shards);

/// Identifies the cells of a plan, their order and the part that each is dealt to. Parts fit together where it is the
/// same.
std::string plan_digest(const Plan& plan, std::size_t shards);

}  // namespace kreisel
