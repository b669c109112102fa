// SPDX-License-Identifier: BSD-3-Clause
//
// Deals the cells of a plan to parts that cost alike. Internal to the plan.
#pragma once

#include <cstddef>
#include <vector>

#include "driver/plan/plan.hpp"

namespace kreisel {

/// The part of each cell, from 1, by their weights and those of the references they need: each part computes its own.
std::vector<std::size_t> deal(const Plan& plan, std::size_t parts);

}  // namespace kreisel
