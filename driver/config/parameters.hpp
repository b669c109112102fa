// SPDX-License-Identifier: BSD-3-Clause
//
// How the parameters of a problem are read. Internal to the reader.
#pragma once

#include <string>
#include <vector>

#include "driver/config/config.hpp"
#include "records/json/node.hpp"

namespace kreisel {

/// One combination of listed parameters.
struct ParameterPoint {
    ParameterValues values;  ///< complete
    std::string listed;      ///< ", links = 8": the values of the parameters that vary
};

/// Fills in the values of `written` (an object); others keep their defaults. A number given as a list is an
/// axis: all combinations, the last parameter of the description varying fastest.
std::vector<ParameterPoint> read_parameters(const Node& written, const ProblemDescription& problem);

}  // namespace kreisel
