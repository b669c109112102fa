// SPDX-License-Identifier: BSD-3-Clause
//
// What the campaign suites share: default parameters and options.
#pragma once

#include <string>

#include "experiments/engine.hpp"
#include "tests/order_rule.hpp"

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

}  // namespace kreisel::acceptance
