// SPDX-License-Identifier: BSD-3-Clause
//
// What every system must satisfy at every state, each as a function that returns a complaint, or an empty text. The
// controls beside this file are systems with one fault each, which these functions must complain about.
#pragma once

#include <string>
#include <vector>

#include "mechanics/formulation.hpp"

namespace checks {

using namespace kreisel;

/// Time and state (q, v) in the coordinates of a system.
struct At {
    Real t;
    std::vector<Real> y;
};

/// M is symmetric and positive definite.
std::string mass_is_positive(System& s, const At& at);
/// C e_i = d/de Phi(t, q exp(e e_i)).
std::string jacobian_is_derivative(System& s, const At& at);
/// b = dPhi/dt at fixed q, and the velocity residual is C v + b.
std::string velocity_rows_are_consistent(System& s, const At& at);
/// C a - xi = d/dt (C v + b) along q' = q v, v' = a, for arbitrary a.
std::string bias_is_derivative(System& s, const At& at);
/// v' and lambda satisfy M v' + C^T lambda = Q and C v' = xi.
std::string accelerations_solve_kkt(System& s, const At& at);
/// Without constraints, the applied force is minus the left derivative of the potential, where there is one.
std::string force_is_gradient(System& s, const At& at);
/// The applied force is its conservative part, which acts at rest, and a dissipative one, which takes energy out and is
/// zero where there are no dampers.
std::string force_parts_add_up(System& s, const At& at);
/// Every first integral has a vanishing derivative along the vector field. Meant for states that satisfy the joints.
std::string integrals_are_constant(System& s, const At& at);

/// The output of a system at a state: x'' and omega' of each body, and its multipliers.
struct Dynamics {
    VecX accelerations, multipliers;
};
Dynamics dynamics(System& s, const At& at);
/// Complains if two of them differ; multipliers count if both have them.
std::string same_dynamics(const Dynamics& a, const Dynamics& b);

}  // namespace checks
