// SPDX-License-Identifier: BSD-3-Clause
//
// How the parameters of a problem are read. Internal to the reader.
#pragma once

#include <string>
#include <vector>

#include "driver/config/config.hpp"
#include "driver/config/reading/printed.hpp"
#include "records/json/node.hpp"

namespace kreisel {

/// One combination of listed parameters.
struct ParameterPoint {
    ParameterValues values;  ///< complete
    std::string listed;      ///< ", links = 8": the values of the parameters that vary
};

/// Fills in the values of `written` (an object); others keep their defaults. {"axis": [...]} is an axis, and so is a
/// list of numbers where one is expected: all combinations, the last parameter of the description varying fastest.
/// Axes with a common "zip" vary together, as the first of them.
std::vector<ParameterPoint> read_parameters(const Node& written, const ProblemDescription& problem,
                                            const PrintedNumbers& printed);

}  // namespace kreisel
