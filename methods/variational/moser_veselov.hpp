// SPDX-License-Identifier: BSD-3-Clause
//
// The discrete Moser-Veselov algorithm [moserveselov1991] for bodies on which nothing acts, preprocessed to order 2k
// [hairervilmart2006]: in principal axes, with the momentum m and modified moments I~, a quaternion (1, c) of the step
// and alpha = 1 + |c|^2,
//   c_1 = alpha h m_1 / (2 I~_1) + (I~_2 - I~_3)/I~_1 c_2 c_3,   and cyclically,
//   m_1+ = m_1 + 4/(h alpha) (I~_2 - I~_3) c_2 c_3,   q+ = q (1, c)/sqrt(alpha),
//   1/I~_j = s/I_j + d,   s = 1 + h^2 s_3 + h^4 s_5 + ...,   d = h^2 d_3 + h^4 d_5 + ...,
// s_i and d_i being polynomials in H = m.I^{-1} m / 2 and C = |m|^2 / 2 (methods/variational/modified_moments.hpp).
// These are constants of the algorithm for any I~, so that energy, momentum in space axes and time reversal are exact
// for all orders. Order 2, I~ = I, is variational and symplectic too; dependence of I~ on m need not be.
#pragma once

#include <string>
#include <vector>

#include "methods/contract/method.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Of order 2 (terms + 1), with this many terms s_i and d_i, 0 to 4.
Factory moser_veselov(int terms);

/// What all orders preserve.
std::vector<Claim> preserved_by_moser_veselov();

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
