// SPDX-License-Identifier: BSD-3-Clause
//
// Parts of a config, by the names on its axes.
#pragma once

#include <string>
#include <vector>

#include "driver/config/config.hpp"

namespace kreisel {

/// Leaves on each axis what fits. A filter is AXIS=PATTERN or AXIS=PATTERN,PATTERN...; AXIS is problems, formulations,
/// methods, projections or precision; a name that fits one of the patterns stays (`*` stands for any characters), of a
/// problem its name or label. Several filters hold together. The config keeps what it was as `whole`. Throws UsageError,
/// with the nearest name, where nothing is left.
void apply_filters(const std::vector<std::string>& filters, Config& config);

}  // namespace kreisel
