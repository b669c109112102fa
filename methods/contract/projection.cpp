// SPDX-License-Identifier: BSD-3-Clause
#include "methods/contract/projection.hpp"

#include <algorithm>
#include <stdexcept>

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

std::vector<ProjectionMethod>& registry() {
    static std::vector<ProjectionMethod> all;
    return all;
}

}  // namespace

ProjectionRegistration::ProjectionRegistration(
    const char* file, ProjectionDescription description,
    std::function<std::unique_ptr<Projection>(System&, const OptionValues&)> make) {
    registry().push_back({std::move(description), std::move(make), file});
}

const std::vector<ProjectionMethod>& projections() {
    static const std::vector<ProjectionMethod> sorted = [] {
        auto all = registry();
        std::sort(all.begin(), all.end(), [](const ProjectionMethod& a, const ProjectionMethod& b) {
            return a.description.name < b.description.name;
        });
        return all;
    }();
    return sorted;
}

const ProjectionMethod& projection(const std::string& name) {
    for (const ProjectionMethod& entry : projections())
        if (entry.description.name == name) return entry;
    throw std::out_of_range("no projection \"" + name + "\"");
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
