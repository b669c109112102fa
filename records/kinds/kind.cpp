// SPDX-License-Identifier: BSD-3-Clause
#include "records/kinds/kind.hpp"

#include <algorithm>

namespace kreisel {

namespace {

std::vector<ExperimentKind>& registered_kinds() {
    static std::vector<ExperimentKind> all;
    return all;
}

}  // namespace

ExperimentRegistration::ExperimentRegistration(ExperimentKind kind) { registered_kinds().push_back(std::move(kind)); }

const std::vector<ExperimentKind>& experiment_kinds() {
    static const std::vector<ExperimentKind> sorted = [] {
        auto all = registered_kinds();
        std::sort(all.begin(), all.end(),
                  [](const ExperimentKind& a, const ExperimentKind& b) { return a.name < b.name; });
        return all;
    }();
    return sorted;
}

const ExperimentKind* find_experiment_kind(const std::string& name) {
    const auto& all = experiment_kinds();
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const ExperimentKind& kind) { return kind.name == name; });
    return found == all.end() ? nullptr : &*found;
}

}  // namespace kreisel
