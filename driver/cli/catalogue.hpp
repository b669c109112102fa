// SPDX-License-Identifier: BSD-3-Clause
//
// `kreisel list` and `kreisel info`: what is available, according to the registries.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "driver/cli/catalogue/traits.hpp"
#include "driver/config/catalogue.hpp"

namespace kreisel {

/// What can be listed: problems, methods, projections, formulations, metrics, kinds, figures, tables, configs.
const std::vector<std::string>& catalogue_topics();

/// Prints one topic, or all if `topic` is empty. A filter selects methods, the only topic then; throws UsageError for
/// another one.
void list_topic(const Engine& engine, const std::string& topic, const MethodFilter& filter, std::ostream& out);

/// Prints all about one name. Throws UsageError, with the nearest name, if there is none.
void describe(const Engine& engine, const std::string& name, std::ostream& out);

}  // namespace kreisel
