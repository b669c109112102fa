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
    /// Why the model has no such formulation; empty if it has.
    std::string (*why_not)(const Model&);
    std::unique_ptr<System> (*make)(const Model&);
};

const std::vector<Formulation>& formulations();

/// Throws std::out_of_range for an unknown name.
const Formulation& formulation(const std::string& name);

/// The first integrals of a model, each with the reason why it holds (mechanics/integrals.cpp).
std::vector<FirstIntegral> first_integrals(const Model& model);

/// The system in a formulation that applies, its first integrals attached.
std::unique_ptr<System> make_system(const Model& model, const std::string& formulation);

/// Checks that a model starts on its constraints: each row of Phi at most 1e-9 of its scale, each row of C v + b at most 1e-9
/// of its scale times the rate of the motion (where all is at rest, that of what the forces make of it), both but for the
/// round-off of data given in double precision, which grows with the distance from the origin; and rows that follow from
/// others met by the accelerations. Throws ParameterError naming the joints and their residuals.
void check_start(const Model& model);

/// How far project_start moved the bodies: the largest distance (m), angle (rad), change of velocity (m/s) and of angular
/// velocity (rad/s) of any of them.
struct StartCorrection {
    Real position = 0, rotation = 0, velocity = 0, omega = 0;
    bool noise = true;  ///< no more than the round-off of data given in double precision
};

/// Moves the start onto the constraints, first positions, then velocities, by steps that are least in the metric M. Throws
/// ParameterError, naming the joints and their residuals, where that does not converge.
StartCorrection project_start(Model& model);

/// What a model whose start is allowed is warned of: a singular position, where the rank of the constraints is less than
/// beside it; rows so nearly dependent, in position or by the ratio of masses, that a solve keeps fewer than six digits (of
/// at most 120 rows, both); a torsion spring whose axes the joints let part.
std::vector<std::string> start_warnings(const Model& model);

/// The state in which a model starts.
std::vector<Real> initial_state(const System& system, const Model& model);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
