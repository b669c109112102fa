// SPDX-License-Identifier: BSD-3-Clause
#include "methods/contract/projection.hpp"

#include "mechanics/system.hpp"
#include "methods/contract/every_step.hpp"
#include "support/registered.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// Options may be given in part.
MakeProjection at_every_step(MakeProjection make, const std::vector<OptionDescription>& options) {
    return [make = std::move(make), options](System& system, const OptionValues& given) {
        const OptionValues values = with_defaults(given, options);
        return every_steps(std::get<long>(values.at("every")), make(system, values));
    };
}

}  // namespace

ProjectionRegistration::ProjectionRegistration(const char* file, ProjectionDescription description,
                                               MakeProjection make) {
    if (description.positions || description.velocities) {
        description.options.push_back(every_option());
        make = at_every_step(std::move(make), description.options);
    }
    Registered<ProjectionMethod>::add({std::move(description), std::move(make), file});
}

ProjectionRegistration::ProjectionRegistration(const char* file, ProjectionDescription description,
                                               Stabilisation stabilisation) {
    const auto make = [](System&, const OptionValues&) { return std::make_unique<NoProjection>(); };
    Registered<ProjectionMethod>::add({std::move(description), make, file, std::move(stabilisation)});
}

std::unique_ptr<System> ProjectionMethod::changed(System& system, const OptionValues& options) const {
    return stabilises() ? stabilisation.change(system, with_defaults(options, description.options)) : nullptr;
}

std::string ProjectionMethod::why_not(const MethodDescription& method) const {
    return stabilisation.why_not ? stabilisation.why_not(method) : "";
}

const std::vector<ProjectionMethod>& projections() { return Registered<ProjectionMethod>::all(); }

const ProjectionMethod& projection(const std::string& name) {
    return Registered<ProjectionMethod>::named(name, "projection");
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
