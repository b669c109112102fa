// SPDX-License-Identifier: BSD-3-Clause
//
// The formulation, which group a body lives on, is an axis of an experiment and not part of a problem. Each is one file
// in mechanics/formulations/, which registers it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "mechanics/blocks/solver_choice.hpp"
#include "mechanics/system.hpp"
#include "support/registration.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

inline std::string applies_always(const Model&) { return ""; }

struct Formulation {
    std::string name, summary;
    int place = 1000;                     ///< in lists; where equal, names decide
    std::vector<std::string> cites = {};  ///< keys of paper/references.bib
    /// Why the formulation does not apply to the model; empty if it does.
    std::string (*why_not)(const Model&) = applies_always;
    std::unique_ptr<System> (*make)(const Model&) = nullptr;
    /// The same with the solver for joints of any kind, even where the model has a simpler one; null in a formulation
    /// without constraints.
    std::unique_ptr<System> (*make_general)(const Model&, SolverChoice) = nullptr;
};

/// All that are registered, in the order of their places.
const std::vector<Formulation>& formulations();

/// Throws std::out_of_range for an unknown name.
const Formulation& formulation(const std::string& name);

/// The system in a formulation that applies, its first integrals attached.
std::unique_ptr<System> make_system(const Model& model, const std::string& formulation);

/// The state in which a model starts.
std::vector<Real> initial_state(const System& system, const Model& model);

/// Records a formulation; a static object of this type is what KREISEL_FORMULATION declares.
struct FormulationRegistration {
    explicit FormulationRegistration(Formulation formulation);
};

/// KREISEL_FORMULATION({.name = "...", .summary = "...", .make = ...}).
#define KREISEL_FORMULATION(...) KREISEL_REGISTER(::kreisel::FormulationRegistration, __VA_ARGS__)

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
