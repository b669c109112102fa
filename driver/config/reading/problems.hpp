// SPDX-License-Identifier: BSD-3-Clause
//
// How problems are read. Internal to the reader.
#pragma once

#include "driver/config/config.hpp"
#include "records/json/node.hpp"

namespace kreisel {

/// Reads "problems" of the config `root`.
void read_problems(const Node& root, const Catalogue& catalogue, Config& config);

}  // namespace kreisel
