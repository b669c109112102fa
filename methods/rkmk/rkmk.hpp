// SPDX-License-Identifier: BSD-3-Clause
//
// Munthe-Kaas lift of an explicit Runge-Kutta method, the seed's algorithm [munthekaas1998], [terzezlatarmueller,
// Sec. 2.2.2], in left trivialisation: with y = y_n psi(u) on TG,
//   u_i = h sum_j a_ij k~_j,   k_i = F(t_n + c_i h, y_n psi(u_i)),   k~_i = dpsi^{-1}_{-u_i}(k_i),
//   y_{n+1} = y_n psi(h sum_j b_j k~_j).
// Options: `coordinates` exp, cayley or second_kind; `dexpinv` exact, seed (q = p - 1 brackets for declared order p) or
// a count q.
#pragma once

#include "methods/contract/method.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

Factory rkmk(const Tableau& tableau);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
