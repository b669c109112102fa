// SPDX-License-Identifier: BSD-3-Clause
//
// Commutator-free methods [celledoni2003cf], products of exponentials of combinations of slopes, in left
// trivialisation: factors append on the right,
//   y_i = y_n exp(h sum_j alpha^i_1j K_j) exp(h sum_j alpha^i_2j K_j) ...,   K_i = F(t_n + c_i h, y_i),
// and y_{n+1} alike; c_i is the sum of the coefficients of y_i. A pair estimates its error by e = log(y^_{n+1}^{-1}
// y_{n+1}) [curryowren2019]. Stages that only y^ uses are taken only in attempts.
// Trap: the literature writes Y' = A(Y) Y, where the same products stand in reverse. The final factors of CF4 exchanged
// leave order 2, and every matrix orthogonal.
#pragma once

#include "methods/contract/method.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Integrators throw std::invalid_argument where a product uses a stage that is not before it, or the coefficients of a
/// solution do not sum to 1.
Factory commutator_free(const CommutatorFreeScheme& scheme);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
