// SPDX-License-Identifier: BSD-3-Clause
//
// The key "x" of figures of errors, and of those over time.
#pragma once

#include "plots/figures/values.hpp"
#include "plots/laws/abscissa.hpp"

namespace kreisel {

/// A name of plots/laws/abscissa.hpp.
inline figure_value::Type<std::string> abscissa_value(const std::vector<Abscissa>& all = abscissae()) {
    std::vector<std::string> names;
    for (const Abscissa& one : all) { names.push_back(one.name); }
    return figure_value::choice("axis", names);
}

}  // namespace kreisel
