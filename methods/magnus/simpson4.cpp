// SPDX-License-Identifier: BSD-3-Clause
//
// Explicit Magnus method of order 4 for nonlinear equations Y' = A(t, Y) Y, the fourth iterate of
//   Omega(h) = int_0^h sum_p B_p/p! ad_Omega^p A(s, exp(Omega(s)) Y_n) ds,
// each by Simpson's rule. As printed, with k_i = h A(t_n + c_i h, exp(u_i) Y_n) and Q_1 = k_1, Q_2 = k_2 - k_1,
// Q_3 = k_3 - k_2, Q_4 = k_4 - 2 k_2 + k_1, Q_5 = k_5 - k_2, Q_6 = k_6 - 2 k_2 + k_1:
//   u_2 = Q_1/2,   u_3 = Q_1/2 + Q_2/4,   u_4 = Q_1 + Q_2,
//   u_5 = Q_1/2 + Q_2/4 + Q_3/3 - Q_4/24 - [Q_1, Q_2]/48,
//   u_6 = Q_1 + Q_2 + 2/3 Q_3 + Q_4/6 - [Q_1, Q_2]/6,
//   v = Q_1 + Q_2 + 2/3 Q_5 + Q_6/6 - [Q_1, Q_2 - Q_3 + Q_5 + Q_6/2]/6.
// Source: [casasiserles2006].
#include "methods/rkmk/few_commutators.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

static const FewCommutatorsScheme magnus_simpson4{
    .stages = {{},
               {.weights = {{1, 2}}},
               {.weights = {{1, 4}, {1, 4}}},
               {.weights = {0, 1}},
               {.weights = {{5, 24}, 0, {1, 3}, {-1, 24}}, .brackets = {{1, 2, {-1, 48}}}},
               {.weights = {{1, 6}, 0, {2, 3}, {1, 6}}, .brackets = {{1, 2, {-1, 6}}}}},
    .result = {.weights = {{1, 6}, 0, 0, 0, {2, 3}, {1, 6}},
               .brackets = {{1, 3, {1, 6}}, {1, 5, {-1, 6}}, {1, 6, {-1, 12}}}},
};

KREISEL_METHOD(few_commutators(magnus_simpson4),
               {.name = "magnus/simpson4",
                .order = 4,
                .cites = {"casasiserles2006"},
                .summary = "explicit Magnus method of order 4 for nonlinear equations, Simpson's rule"});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
