// SPDX-License-Identifier: BSD-3-Clause
//
// Crouch-Grossman methods, products of exponentials of frozen slopes [crouchgrossman1993], [owrenmarthinsen1999], in
// left trivialisation: factors append on the right, in the order of the stages,
//   y_i = y_n exp(h a_i1 K_1) ... exp(h a_i,i-1 K_{i-1}),   K_i = F(t_n + c_i h, y_i),
//   y_{n+1} = y_n exp(h b_1 K_1) ... exp(h b_s K_s).
// A pair estimates its error by e = log(y^_{n+1}^{-1} y_{n+1}); stages that only y^ uses are taken only in attempts.
// Trap: the literature writes Y' = A(Y) Y, where the same products stand in reverse. Reversed stage products leave CG3a
// at order 3, where no order test sees them, and lower CG4a to 3; rows given backwards (a_ij to stage i - j) lower it
// to 2.
#pragma once

#include "methods/contract/method.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

Factory crouch_grossman(const Tableau& tableau);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
