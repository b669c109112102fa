// SPDX-License-Identifier: BSD-3-Clause
//
// A formulation whose bodies have six velocity coordinates each, from its Coordinates
// (mechanics/formulations/body_layout.hpp): joints are constraints, and the structure of the model decides how they are
// solved.
#pragma once

#include "mechanics/formulation.hpp"
#include "mechanics/formulations/jointed_bodies.hpp"
#include "mechanics/formulations/spherical_bodies.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Spherical joints without loops have a solver of their own.
template <class Coordinates>
std::unique_ptr<System> make_bodies(const Model& model) {
    if (SphericalBodies<Coordinates>::fits(model)) return std::make_unique<SphericalBodies<Coordinates>>(model);
    return std::make_unique<JointedBodies<Coordinates>>(model);
}

template <class Coordinates>
std::unique_ptr<System> make_jointed_bodies(const Model& model, SolverChoice choice) {
    return std::make_unique<JointedBodies<Coordinates>>(model, choice);
}

/// The formulation of these coordinates, under its name and summary; it applies to every model.
template <class Coordinates>
Formulation body_formulation(Formulation formulation) {
    formulation.make = make_bodies<Coordinates>;
    formulation.make_general = make_jointed_bodies<Coordinates>;
    return formulation;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
