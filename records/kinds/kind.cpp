// SPDX-License-Identifier: BSD-3-Clause
#include "records/kinds/kind.hpp"

#include "support/registered.hpp"

namespace kreisel {

ExperimentRegistration::ExperimentRegistration(ExperimentKind kind) {
    Registered<ExperimentKind>::add(std::move(kind));
}

const std::vector<ExperimentKind>& experiment_kinds() { return Registered<ExperimentKind>::all(); }

const ExperimentKind* find_experiment_kind(const std::string& name) { return Registered<ExperimentKind>::find(name); }

}  // namespace kreisel
