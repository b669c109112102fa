// SPDX-License-Identifier: BSD-3-Clause
//
// Why a config is refused: for its shape, which the JSON Schema (`kreisel schema`) tells as well, or by a rule of its
// meaning, which a schema cannot tell.
#pragma once

#include <string>
#include <vector>

namespace kreisel {

enum class Rule {
    shape,
    each_once,
    own_name,
    separators,
    whole_steps,
    whole_strides,
    begin,
    finest_level,
    symmetry,
    unit_norm,
    zipped,
    file,
    model,
    options,
    quad,
    metric,
    figure_metric,
    figure_selection,
    figure_curve,
    figure_body,
    figure_until,
    figure_range,
};

struct RuleDescription {
    Rule rule = Rule::shape;
    std::string name;      ///< "each-once"
    std::string sentence;  ///< what holds of a config
};

/// The rules of meaning: all but the shape. docs/how-to/check-configs.md lists the same.
const std::vector<RuleDescription>& rules_of_meaning();

}  // namespace kreisel
