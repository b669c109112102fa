// SPDX-License-Identifier: BSD-3-Clause
//
// What `kreisel list` and `kreisel info` say of methods and projections.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "driver/cli/catalogue/rows.hpp"
#include "engine/engine.hpp"

namespace kreisel {

/// Which methods are listed: of a family, and of those that declare all of these properties on some class of systems.
struct MethodFilter {
    std::string family;  ///< empty: all
    std::vector<Property> preserves;
    bool empty() const { return family.empty() && preserves.empty(); }
    bool fits(const MethodDescription& method) const;
};

/// Name, order and summary of each, with the properties it declares.
std::vector<NamedText> method_rows(const std::vector<MethodDescription>& methods);

void describe_method(const MethodDescription& method, std::ostream& out);
void describe_projection(const ProjectionDescription& projection, std::ostream& out);

}  // namespace kreisel
