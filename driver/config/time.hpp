// SPDX-License-Identifier: BSD-3-Clause
//
// How end time and numbers of steps are read. Internal to the reader.
#pragma once

#include "driver/config/config.hpp"
#include "records/json/node.hpp"

namespace kreisel {

inline constexpr const char* time_expectation = R"(an object with "end" and "steps", "step" or "tolerance")";

/// The rules by which steps are chosen to a tolerance.
const std::vector<std::string>& step_controllers();

/// Reads "time" into t_end, steps, tolerances and controller.
void read_time(const Node& time, Config& config);

}  // namespace kreisel
