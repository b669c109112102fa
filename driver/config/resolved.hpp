// SPDX-License-Identifier: BSD-3-Clause
//
// A config written out.
#pragma once

#include <string>

#include "driver/config/config.hpp"

namespace kreisel {

/// The config with all defaults written out. It is itself a config and gives the same plan.
std::string resolved_config(const Config& config);

}  // namespace kreisel
