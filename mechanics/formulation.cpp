// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/formulation.hpp"

#include "mechanics/integrals.hpp"
#include "support/registered.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

FormulationRegistration::FormulationRegistration(Formulation formulation) {
    Registered<Formulation>::add(std::move(formulation));
}

const std::vector<Formulation>& formulations() { return Registered<Formulation>::all(); }

const Formulation& formulation(const std::string& name) { return Registered<Formulation>::named(name, "formulation"); }

std::unique_ptr<System> make_system(const Model& model, const std::string& name) {
    auto system = formulation(name).make(model);
    system->set_integrals(first_integrals(model));
    return system;
}

std::vector<Real> initial_state(const System& system, const Model& model) {
    std::vector<BodyState> states;
    for (const Body& body : model.bodies) states.push_back(body.start);
    std::vector<Real> y(static_cast<std::size_t>(system.state_group().size()));
    system.write(states.data(), y.data());
    Real* const labels = system.labels(y.data());
    std::vector<SpringAngle> angles(static_cast<std::size_t>(system.torsion_springs()));
    for (std::size_t i = 0; i < angles.size(); ++i) labels[i] = 2 * pi() * Real(model.torsion_springs[i].turns);
    system.read_angles(y.data(), angles.data());
    for (std::size_t i = 0; i < angles.size(); ++i) labels[i] = angles[i].theta;
    return y;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
