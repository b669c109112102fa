// SPDX-License-Identifier: BSD-3-Clause
//
// How the parameters of a problem are read. Internal to the reader.
#pragma once

#include <vector>

#include "driver/config/config.hpp"
#include "driver/config/reading/printed.hpp"
#include "records/json/node.hpp"

namespace kreisel {

/// The parameters of a problem, complete, and those that vary.
struct ReadParameters {
    ParameterValues values;
    std::vector<std::size_t> axes = {};  ///< how many places each has
    std::vector<VaryingParameter> varying = {};
};

/// Fills in the values of `written` (an object); others keep their defaults. {"axis": [...]} is an axis, and so is a
/// list of numbers where one is expected: all combinations, the last parameter of the description varying fastest.
/// Axes with a common "zip" vary together, as the first of them.
ReadParameters read_parameters(const Node& written, const ProblemDescription& problem, const PrintedNumbers& printed);

}  // namespace kreisel
