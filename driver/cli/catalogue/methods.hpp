// SPDX-License-Identifier: BSD-3-Clause
//
// What `kreisel list` and `kreisel info` say of methods and projections.
#pragma once

#include <iosfwd>
#include <vector>

#include "driver/cli/catalogue/rows.hpp"
#include "engine/engine.hpp"

namespace kreisel {

/// Name, order and summary of each.
std::vector<NamedText> method_rows(const std::vector<MethodDescription>& methods);

void describe_method(const MethodDescription& method, std::ostream& out);
void describe_projection(const ProjectionDescription& projection, std::ostream& out);

}  // namespace kreisel
