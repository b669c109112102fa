// SPDX-License-Identifier: BSD-3-Clause
//
// How end time and numbers of steps are read. Internal to the reader.
#pragma once

#include "driver/config/config.hpp"
#include "records/json/node.hpp"

namespace kreisel {

/// Reads "time" into t_end, steps, tolerances and controller.
void read_time(const Node& time, Config& config);

}  // namespace kreisel
