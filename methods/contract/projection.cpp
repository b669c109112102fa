// SPDX-License-Identifier: BSD-3-Clause
#include "methods/contract/projection.hpp"

#include "support/registered.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

ProjectionRegistration::ProjectionRegistration(
    const char* file, ProjectionDescription description,
    std::function<std::unique_ptr<Projection>(System&, const OptionValues&)> make) {
    Registered<ProjectionMethod>::add({std::move(description), std::move(make), file});
}

const std::vector<ProjectionMethod>& projections() { return Registered<ProjectionMethod>::all(); }

const ProjectionMethod& projection(const std::string& name) {
    return Registered<ProjectionMethod>::named(name, "projection");
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
