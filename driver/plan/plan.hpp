// SPDX-License-Identifier: BSD-3-Clause
//
// The cells of an experiment: the cross product of the axes of its config, in a fixed order.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "driver/config/config.hpp"
#include "driver/plan/cells/systems.hpp"
#include "records/cell/planned.hpp"

namespace kreisel {

struct Plan {
    Config config;
    std::vector<PlannedCell> cells;
    std::map<std::string, PlannedReference> references;  ///< by hash
    PlannedSystems systems;                              ///< of its problems in its formulations
    std::vector<std::string> warnings;
    std::size_t skipped() const;
};

/// Crosses the axes and asks the engines about each combination. The order is problems, formulations, methods,
/// projections, precisions, steps, the last varying fastest. Throws UsageError if parameters do not describe a system,
/// an option value is not allowed, or a metric does not exist.
Plan make_plan(const Document& document, const Config& config, const Engines& engines);

/// read_config and make_plan.
Plan plan_of(const Document& document, const Engines& engines);

}  // namespace kreisel
