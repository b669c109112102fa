// SPDX-License-Identifier: BSD-3-Clause
//
// Munthe-Kaas lifts of the Gauss methods [hairer2006, II.1.3] to TG in the symmetrised form [zanna2001], in coordinates
// around the middle of the step, which makes them symmetric: with s stages, order 2 s,
//   theta = h sum_j b_j k_j,   Q_i = q exp(theta/2) exp(u_i),   u_i = -theta/2 + h sum_j a_ij k_j,
//   k_i = dexp^{-1}_{-u_i}(V_i),   V_i = v + h sum_j a_ij f_j,   f_i = v' of the index-1 form at (t + c_i h, Q_i, V_i),
//   q+ = q exp(theta),   v+ = v + h sum_i b_i f_i.
// Exchanging the ends, and h by -h, turns theta and the u_i around and the stages over. In coordinates around q, the
// usual ones of Munthe-Kaas methods, this holds for s = 1 only, the method rkmk/implicit_midpoint, where u_1 = 0.
#pragma once

#include "methods/contract/method.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Of 2 or 3 stages.
Factory gauss(int stages);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
