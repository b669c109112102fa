// SPDX-License-Identifier: BSD-3-Clause
//
// What the campaign suites share: default parameters and options, and what an error metric is held against.
#pragma once

#include <string>

#include "experiments/engine.hpp"

namespace kreisel::acceptance {

inline ParameterValues defaults(const std::string& problem) {
    ParameterValues values;
    for (const ProblemDescription& description : engine_binary64().problems())
        if (description.name == problem)
            for (const ParameterDescription& parameter : description.parameters)
                values[parameter.name] = parameter.standard;
    return values;
}

inline OptionValues standard_options(const MethodDescription& method) {
    OptionValues options;
    for (const OptionDescription& option : method.options) options[option.name] = option.standard;
    return options;
}

inline bool is_velocity(const std::string& metric) { return metric == "error.velocity" || metric == "error.omega"; }

inline int declared(const Order& order, const std::string& metric) {
    if (metric == "error.multipliers") return order.multipliers;
    return is_velocity(metric) ? order.velocity : order.configuration;
}

/// Sizes of the quantities on these problems, for what counts as round-off and as pre-asymptotic.
inline double scale_of(const std::string& metric) {
    return metric == "error.multipliers" ? 100 : is_velocity(metric) ? 5 : 1;
}

}  // namespace kreisel::acceptance
