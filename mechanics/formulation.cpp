// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/formulation.hpp"

#include <stdexcept>

#include "mechanics/formulations/jointed_bodies.hpp"
#include "mechanics/formulations/pivoted_bodies.hpp"
#include "mechanics/formulations/spherical_bodies.hpp"
#include "mechanics/integrals.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

std::string always(const Model&) { return ""; }

/// Spherical joints without loops have a solver of their own.
template <class Coordinates>
std::unique_ptr<System> make_bodies(const Model& model) {
    if (SphericalBodies<Coordinates>::fits(model)) return std::make_unique<SphericalBodies<Coordinates>>(model);
    return std::make_unique<JointedBodies<Coordinates>>(model);
}

std::unique_ptr<System> make_pivoted(const Model& model) { return std::make_unique<PivotedBodies>(model); }

}  // namespace

const std::vector<Formulation>& formulations() {
    static const std::vector<Formulation> all = {
        {"SO3xR3", "rotation and position of each body apart: q = (x, R), v = (x', omega); joints are constraints",
         always, make_bodies<SO3xR3Coordinates>},
        {"SE3", "rigid displacement of each body: q = (x, R), v = (R^T x', omega); joints are constraints", always,
         make_bodies<SE3Coordinates>},
        {"S3xR3",
         "unit quaternion and position of each body apart: q = (x, a), v = (x', omega); joints are constraints", always,
         make_bodies<S3xR3Coordinates>},
        {"SO3", "bodies that turn about a fixed point: q = R, v = omega; no constraint is left", PivotedBodies::why_not,
         make_pivoted},
    };
    return all;
}

const Formulation& formulation(const std::string& name) {
    for (const Formulation& entry : formulations())
        if (entry.name == name) return entry;
    throw std::out_of_range("no formulation \"" + name + "\"");
}

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
