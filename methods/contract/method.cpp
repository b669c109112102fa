// SPDX-License-Identifier: BSD-3-Clause
#include "methods/contract/method.hpp"

#include <stdexcept>
#include <utility>

#include "mechanics/actions/acted_upon.hpp"
#include "methods/contract/turn_counting.hpp"
#include "support/registered.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// What a method declines that moves states in TG only.
auto declining_actions(std::function<std::string(const System&)> declines) {
    return [own = std::move(declines)](const System& system) -> std::string {
        if (action_on(system)) return "momenta that move on coadjoint orbits";
        return own ? own(system) : "";
    };
}

}  // namespace

MethodRegistration::MethodRegistration(const char* file, Factory factory, MethodDescription description) {
    description.options = factory.options;
    description.stages = factory.stages;
    if (!factory.takes_actions) factory.declines = declining_actions(std::move(factory.declines));
    Registered<Method>::add({std::move(description), std::move(factory), file});
}

MethodDescription Method::under(const OptionValues& options) const {
    MethodDescription described = description;
    described.order = factory.order(options, description.order);
    described.estimate = factory.estimate(options, description.estimate);
    return described;
}

std::unique_ptr<Integrator> Method::bind(System& system, const OptionValues& options) const {
    if (!factory.make)
        throw std::logic_error(description.name + " has no steps of a given size, it chooses them to a tolerance");
    return counting_turns(system, factory.make(system, options, description));
}

const std::vector<Method>& methods() { return Registered<Method>::all(); }

const Method& method(const std::string& name) { return Registered<Method>::named(name, "method"); }

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
