// SPDX-License-Identifier: BSD-3-Clause
//
// The checks that certify a method. Each takes any method, so the checks that accept registered methods are the
// ones that must reject the controls.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "methods/contract/method.hpp"
#include "methods/contract/projection.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

enum class Check {
    order_conditions,  ///< the declared tableau satisfies the conditions of the declared order, and of no higher one
    one_step,          ///< a step is that of the declared scheme, or of the published equations
    order,             ///< the observed order is not below the declared one
    solves,            ///< as many solves of the dynamics per step as declared
    history,           ///< after `start`, a step depends only on (t, h, y)
    attempts,          ///< an attempt at a step is that step, whatever was rejected before it
    reversal,          ///< a symmetric method returns to its start
    symplecticity,     ///< steps of a method that claims to be symplectic preserve the two-form
    momentum,          ///< momenta are kept where that is claimed
    energy,            ///< energy is kept where that is claimed
    bounded_energy,    ///< energy errors do not grow over a long time where a property that implies it is claimed
    constraints,       ///< positions and velocities stay on the constraints where that is claimed
    equivariance,      ///< rigid motions of space commute with a step
    injection,         ///< NaN never ends as ok
    convergence,       ///< a step without a solution never ends as ok
    projection,        ///< a projection reaches the levels it claims, and leaves states on them unchanged
    iterations,        ///< with one iteration it leaves the square of what it found
    every,             ///< it acts at each k-th step, those not counted that are not taken
    stabilisation,     ///< a stabilisation changes the rows as it says, and nothing else
};
const char* name(Check check);

/// The objection to a method, in words; empty: none, or the check does not apply.
using Objection = std::string;

struct Judgement {
    Check check;
    std::function<Objection(const Method&)> objection;
};

/// Those that need no more than a running method. (Conditions and steps of schemes are judged in tests/judges/steps.)
const std::vector<Judgement>& running_checks();

struct ProjectionJudgement {
    Check check;
    std::function<Objection(const ProjectionMethod&)> objection;
};
const std::vector<ProjectionJudgement>& projection_checks();

Objection order_objection(const Method&);
Objection solves_objection(const Method&);
Objection history_objection(const Method&);
Objection attempts_objection(const Method&);
Objection reversal_objection(const Method&);
Objection symplecticity_objection(const Method&);
Objection momentum_objection(const Method&);
Objection energy_objection(const Method&);
Objection bounded_energy_objection(const Method&);
Objection constraints_objection(const Method&);
Objection equivariance_objection(const Method&);
Objection injection_objection(const Method&);
Objection convergence_objection(const Method&);
Objection projection_objection(const ProjectionMethod&);
Objection iterations_objection(const ProjectionMethod&);
Objection every_objection(const ProjectionMethod&);
Objection stabilisation_objection(const ProjectionMethod&);
Objection projection_injection_objection(const ProjectionMethod&);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
