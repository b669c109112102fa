// SPDX-License-Identifier: BSD-3-Clause
//
// Explicit Magnus method of order 2 for nonlinear equations Y' = A(t, Y) Y, the second iterate
//   Omega(h) = int_0^h A(s, exp(Omega_1(s)) Y_n) ds,   Omega_1(s) = s A(0, Y_n),
// by the Gauss point. With k_i = h A(t_n + c_i h, exp(u_i) Y_n):
//   u_2 = k_1/2,   v = k_2.
// On a vector space it is the midpoint rule; its lift rkmk/midpoint pulls k_2 back, which order 2 does not need.
// Source: [casasiserles2006].
#include "methods/rkmk/few_commutators.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

static const FewCommutatorsScheme magnus_gauss2{
    .stages = {{}, {.weights = {{1, 2}}}},
    .result = {.weights = {0, 1}},
};

KREISEL_METHOD(few_commutators(magnus_gauss2),
               {.name = "magnus/gauss2",
                .order = 2,
                .cites = {"casasiserles2006"},
                .summary = "explicit Magnus method of order 2 for nonlinear equations, Gauss point"});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
