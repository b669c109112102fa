// SPDX-License-Identifier: BSD-3-Clause
//
// What figures demand of the rest of a config (driver/config/reading/figure_demands.hpp), as JSON Schema.
#pragma once

#include "driver/config/schema/terms.hpp"

namespace kreisel::schema {

/// A schema of configs for each demand: it holds where no figure demands it, or the config provides it.
Schema demands_of_figures();

}  // namespace kreisel::schema
