// SPDX-License-Identifier: BSD-3-Clause
//
// What methods can be selected by in `kreisel list methods`: their family, and traits that follow from what they
// declare.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "engine/engine.hpp"

namespace kreisel {

/// A yes-or-no question about a method; its name is an option of the command line: "symplectic" for --symplectic.
struct MethodTrait {
    std::string name;
    std::string summary;
    std::function<bool(const MethodDescription&)> holds;
};

/// All traits: what a method preserves, on whatever class of systems, and how its steps are found.
const std::vector<MethodTrait>& method_traits();

struct MethodFilter {
    std::string family;               ///< empty: all
    std::vector<std::string> traits;  ///< names, all of which must hold
    bool selects() const { return !family.empty() || !traits.empty(); }
};

/// Those of a family with all traits. Throws UsageError, with the nearest name, for an unknown family.
std::vector<MethodDescription> selected(const std::vector<MethodDescription>& methods, const MethodFilter& filter);

}  // namespace kreisel
