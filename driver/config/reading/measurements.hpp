// SPDX-License-Identifier: BSD-3-Clause
//
// How is read what cells measure and store, and what is drawn of it. Internal to the reader.
#pragma once

#include "driver/config/config.hpp"
#include "records/json/node.hpp"

namespace kreisel {

/// Reads "output", "metrics" and "figure" of the config `root`, whose kind and steps have been read.
void read_measurements(const Node& root, const Catalogue& catalogue, Config& config);

}  // namespace kreisel
