// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lie/real.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// The order of exp(b_1 B) exp(a_1 A) ... exp(a_s A) exp(b_{s+1} B) as an approximation of exp(A + B), up to 7, for
/// vector fields with [B, [B, [B, A]]] = 0: by the coefficients of all words in A and B, modulo the words that this
/// relation generates [mclachlanquispel2002, Sec. 5].
int splitting_order(const std::vector<Real>& kicks, const std::vector<Real>& drifts);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
