// SPDX-License-Identifier: BSD-3-Clause
//
// Partitioned Munthe-Kaas lift of the Lobatto IIIA-IIIB pair with 3 stages, order 4: positions by IIIA, velocities by
// IIIB, which is a^_ij = b_j (1 - a_ji / b_i), in coordinates around the middle of the step.
//    0  |  0    0    0      1/6 -1/6   0
//   1/2 | 5/24 1/3 -1/24    1/6  1/3   0
//    1  | 1/6  2/3  1/6     1/6  5/6   0
//   ----+-------------------------------------
//       | 1/6  2/3  1/6     1/6  2/3  1/6
// It acts on the index-1 form, whose velocities are not the momenta of [jay1996]: symmetric, and not symplectic.
// Sources: [hairer2006, Sec. II.2.2], centre [zanna2001].
#include "methods/rkmk/implicit_rkmk.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

static const ImplicitTableau lobatto3ab3{
    .a = {{0, 0, 0}, {{5, 24}, {1, 3}, {-1, 24}}, {{1, 6}, {2, 3}, {1, 6}}},
    .b = {{1, 6}, {2, 3}, {1, 6}},
    .c = {0, {1, 2}, 1},
    .a_hat = {{{1, 6}, {-1, 6}, 0}, {{1, 6}, {1, 3}, 0}, {{1, 6}, {5, 6}, 0}},
    .around_middle = true,
};

KREISEL_METHOD(implicit_rkmk(lobatto3ab3),
               {.name = "rkmk/lobatto3ab3",
                .order = 4,
                .cites = {"hairer2006", "munthekaas1999", "zanna2001"},
                .summary = "partitioned Munthe-Kaas lift of the Lobatto IIIA-IIIB pair with 3 stages, symmetric",
                .variable_cost = true,
                .form = Form::implicit,
                .preserves = {{Property::symmetric, Domain::autonomous}}});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
