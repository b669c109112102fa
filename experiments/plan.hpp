// SPDX-License-Identifier: BSD-3-Clause
//
// The cells of an experiment: the cross product of the axes of its config, in a fixed order.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "experiments/config.hpp"

namespace kreisel {

struct PlannedCell {
    Cell cell;
    std::string series;
    std::string label;
    std::string precision;
    std::string hash;         ///< 16 hexadecimal digits over all that decides the numbers
    std::string identity;     ///< the members that begin a result line, up to "t_end", without the closing brace
    std::string skip_reason;  ///< not empty: the cell does not apply, and why
    std::string reference;    ///< name of the reference solution it is compared with; empty: none
    double weight = 0;        ///< relative cost, to start long cells first
    bool quad() const { return precision == "quad"; }
};

/// A reference solution that cells are compared with.
struct PlannedReference {
    std::string problem;
    ParameterValues parameters;
    double t_end = 0;
    std::string content;  ///< all that decides its numbers, as JSON
};

struct Plan {
    Config config;
    std::vector<PlannedCell> cells;
    std::map<std::string, PlannedReference> references;                    ///< by hash
    std::map<std::pair<std::string, std::string>, SystemSummary> systems;  ///< by problem label and formulation
    std::vector<std::string> warnings;
    std::size_t skipped() const;
};

/// Crosses the axes and asks the engines what each combination comes to. The order is problems, formulations, methods,
/// projections, precisions, steps, the last varying fastest. Throws UsageError where parameters describe no system, an
/// option cannot be had, or a metric does not exist.
Plan make_plan(const Document& document, const Config& config, const Engines& engines);

/// read_config and make_plan.
Plan plan_of(const Document& document, const Engines& engines);

}  // namespace kreisel
