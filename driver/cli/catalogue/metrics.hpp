// SPDX-License-Identifier: BSD-3-Clause
//
// What `kreisel list` and `kreisel info` say of metrics, those of first integrals among them.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "driver/cli/catalogue/rows.hpp"
#include "engine/engine.hpp"

namespace kreisel {

std::vector<NamedText> metric_rows();

/// Of the problems with their default parameters, or in their demonstration.
std::vector<std::string> integral_names(const Engine& engine);

/// False if there is no metric of this name.
bool describe_metric(const Engine& engine, const std::string& name, std::ostream& out);

}  // namespace kreisel
