// SPDX-License-Identifier: BSD-3-Clause
#include "driver/plan/cells/systems.hpp"

#include <fmt/format.h>

namespace kreisel {

namespace {

// All that is kept, as text; control characters separate names.
std::string text_of(const SystemSummary& system) {
    const ConstraintSummary& constraints = system.constraints;
    std::string text = fmt::format("{}\n{} {} {} {} {}\n", system.skip_reason, system.bodies, system.velocities,
                                   constraints.rows, constraints.rank, constraints.directions);
    for (const std::string& row : constraints.redundant) { text += row + "\n"; }
    for (const IntegralDescription& integral : system.integrals) {
        text.append("\n").append(integral.name).append("\t").append(integral.unit);
        text.append("\t").append(integral.reason);
    }
    return text;
}

}  // namespace

void PlannedSystems::add(SystemSummary summary) {
    summary.warnings.clear();
    summary.constraints.condition.reset();
    const auto [known, is_new] = known_.emplace(text_of(summary), static_cast<std::uint32_t>(kinds_.size()));
    if (is_new) { kinds_.push_back(std::make_shared<const SystemSummary>(std::move(summary))); }
    order_.push_back(known->second);
}

}  // namespace kreisel
