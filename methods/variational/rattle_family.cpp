// SPDX-License-Identifier: BSD-3-Clause
#include "methods/variational/rattle_family.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

std::string why_not_variational(const System& system) {
    if (system.is_dissipative()) return "forces that depend on velocities (dampers)";
    if (system.position_constraints() < system.constraints()) return "rows without a position level (rolling)";
    return "";
}

}  // namespace

Factory rattle_family(MakeRattle make) {
    Factory factory;
    factory.options = {{.name = "coordinates",
                        .summary = "of increments: exponential or Cayley map",
                        .standard = std::string("exp"),
                        .choices = {"exp", "cayley"}}};
    factory.make = [make = std::move(make)](System& system, const OptionValues& options, const MethodDescription&) {
        const bool cayley = std::get<std::string>(options.at("coordinates")) == "cayley";
        const IncrementChart chart = cayley ? IncrementChart::cayley : IncrementChart::exp;
        return make(system, std::make_unique<RattleEquations>(system, chart));
    };
    factory.declines = why_not_variational;
    return factory;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
