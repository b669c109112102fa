// SPDX-License-Identifier: BSD-3-Clause
//
// The names of the metrics, and patterns over them.
#pragma once

#include <string>
#include <vector>

namespace kreisel {

/// All names a config may mean: those of the table, and for each first integral its own, with their suffixes.
std::vector<std::string> metric_names(const std::vector<std::string>& integrals);

/// True if some `error.*` metric of the end fits one of the patterns, so that a reference is needed.
bool asks_for_errors(const std::vector<std::string>& patterns);
/// The same of those over samples.
bool asks_for_largest_errors(const std::vector<std::string>& patterns);

}  // namespace kreisel
