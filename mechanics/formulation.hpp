// SPDX-License-Identifier: BSD-3-Clause
//
// The formulation, which group a body lives on, is an axis of an experiment and not part of a problem.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "mechanics/system.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

struct Formulation {
    std::string name, summary;
    /// Why the formulation does not apply to the model; empty if it does.
    std::string (*why_not)(const Model&);
    std::unique_ptr<System> (*make)(const Model&);
};

const std::vector<Formulation>& formulations();

/// Throws std::out_of_range for an unknown name.
const Formulation& formulation(const std::string& name);

/// The system in a formulation that applies, its first integrals attached.
std::unique_ptr<System> make_system(const Model& model, const std::string& formulation);

/// The state in which a model starts.
std::vector<Real> initial_state(const System& system, const Model& model);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
