// SPDX-License-Identifier: BSD-3-Clause
//
// Munthe-Kaas methods whose corrections are worked out in the free Lie algebra, so that few brackets are left of
// dexpinv [munthekaasowren1999]: with k_i = h F(t_n + c_i h, Y_i), for Y' = A(Y) Y,
//   u_i = sum_j a_ij k_j + sum c [k_j, k_l],   Y_i = exp(u_i) Y_n,   Y_{n+1} = exp(v) Y_n,
// v of the same form. Schemes are declared as they are printed there; in left trivialisation, Y_i = Y_n exp(u_i), each
// bracket changes its sign, which happens in one place, the engine. A wrong sign leaves order 2.
#pragma once

#include "methods/contract/method.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Integrators throw std::invalid_argument where a sum uses a stage that is not before it, or the weights do not sum to
/// 1.
Factory few_commutators(const FewCommutatorsScheme& scheme);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
