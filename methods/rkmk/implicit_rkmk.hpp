// SPDX-License-Identifier: BSD-3-Clause
//
// Munthe-Kaas lifts of implicit Runge-Kutta methods to TG, or to the group that acts on states in its place
// (methods/implicit/stages/implicit_stages.hpp): with s stages, on TG,
//   k_i = dexp^{-1}_{-u_i}(V_i),   f_i = v' of the index-1 form at (t + c_i h, q exp(u_i), V_i),
//   u_i = h sum_j a_ij k_j,   V_i = v + h sum_j a^_ij f_j,   q+ = q exp(h sum_j b_j k_j),   v+ = v + h sum_j b_j f_j,
// in coordinates around q or around the middle of the step. They have the order of their tableau [munthekaas1999]; a
// partitioned pair, a^ other than a, has that of the pair.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "methods/contract/method.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

struct StageCoefficients;

struct ImplicitTableau {
    std::vector<std::vector<Coefficient>> a;           ///< s rows of s
    std::vector<Coefficient> b, c;                     ///< c_i = sum_j a_ij, which finds the misprinted row
    std::vector<std::vector<Coefficient>> a_hat = {};  ///< of velocities; empty: a
    bool around_middle = false;
};

/// A step by these stages in TG, or in the group that acts on the states of the system in its place.
std::unique_ptr<Integrator> implicit_runge_kutta(System& system, const StageCoefficients& coefficients,
                                                 bool around_middle);

/// Integrators throw std::invalid_argument where sizes differ, sum b is not 1, or a node is not the sum of its row.
Factory implicit_rkmk(const ImplicitTableau& tableau);
/// The same with coefficients in closed form.
Factory implicit_rkmk(int stages, const std::function<StageCoefficients()>& coefficients, bool around_middle);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
