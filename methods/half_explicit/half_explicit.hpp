// SPDX-License-Identifier: BSD-3-Clause
//
// Half-explicit Runge-Kutta methods for the index-2 form M v' + C^T lambda = Q, C v + b = 0 [braseyhairer1993], with an
// explicit first stage [arnold1998], [arnoldmurua1998], lifted to Lie groups like Munthe-Kaas methods [munthekaas1998]:
//   Q_i = q exp(u_i),   u_i = h sum_{j<i} a_ij k_j,   k_j = dexp^{-1}_{-u_j}(V_j),   V_i = v + h sum_{j<i} a_ij v'_j,
//   M v'_j = Q(t + c_j h, Q_j, V_j) - C(Q_j)^T Lambda_j,   Lambda_1 = lambda,
// and Lambda_i, i > 1, is that for which the next velocity meets C(Q_{i+1}) V_{i+1} + b = 0, a linear system. That of
// the second stage is not met: this is what the explicit first stage buys, methods of order 3 and 5 with as many stages
// as without constraints. Of s stages there are s + 1 rows; one is the new state, and
//   lambda+ = sum_i d_i Lambda_i
// is what the next step begins with. The first step takes lambda from the index-1 form.
// Velocities meet their constraints; positions drift by the error of the method.
#pragma once

#include <cstddef>
#include <vector>

#include "methods/contract/method.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

struct HalfExplicitScheme {
    std::vector<std::vector<Coefficient>> a;  ///< rows 2, 3, ..., s + 1
    std::size_t result;                       ///< the row of the new state, 2 to s + 1
    std::vector<Coefficient> d;               ///< s
};

Factory half_explicit(const HalfExplicitScheme& scheme);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
