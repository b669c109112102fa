// SPDX-License-Identifier: BSD-3-Clause
//
// Programs beside kreisel, which some of its commands and tests use.
#pragma once

#include <chrono>
#include <vector>

#include "driver/cli/doctor/finding.hpp"

namespace kreisel {

/// Looks for them on the PATH and asks each for its version. What does not answer and end in time, or answers with an
/// error, has failed.
std::vector<Finding> find_tools(std::chrono::milliseconds patience = std::chrono::seconds(10));

}  // namespace kreisel
