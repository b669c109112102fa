// SPDX-License-Identifier: BSD-3-Clause
//
// What figures select by the names on the axes of a config.
#pragma once

#include <string>
#include <vector>

#include "driver/config/config.hpp"
#include "plots/figures/figure.hpp"
#include "records/json/diagnostics.hpp"

namespace kreisel {

/// The values that `select` may name under a key; those of names with options are not known before the run.
std::vector<std::string> selectable(const std::string& key, const Config& config);

/// Whether a value names a method or a projection with options, as cells are called.
bool has_options(const std::string& key, const std::string& value);

/// The place in a document of entry i under a key that holds one value or a list, or is left out.
std::string place_of_entry(const Document& document, const std::string& pointer, std::size_t i);

/// Refuses values under `select` that the config has not. Parameters and options are known when the cells are.
void check_selected_names(const Document& document, const Config& config, const Figure& figure, Diagnostics& sink);

}  // namespace kreisel
