// SPDX-License-Identifier: BSD-3-Clause
//
// How methods and projections are read, with their options. Internal to the reader.
#pragma once

#include "driver/config/config.hpp"
#include "records/json/node.hpp"

namespace kreisel {

/// Reads "methods" and "projections" of the config `root`.
void read_methods(const Node& root, const Catalogue& catalogue, Config& config);

}  // namespace kreisel
