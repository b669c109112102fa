// SPDX-License-Identifier: BSD-3-Clause
//
// Partitioned Munthe-Kaas lift of the Lobatto IIIA-IIIB pair with 2 stages, order 2: positions by IIIA, velocities by
// IIIB, which is a^_ij = b_j (1 - a_ji / b_i), in coordinates around the middle of the step.
//    0 |  0   0     1/2  0
//    1 | 1/2 1/2    1/2  0
//   ---+-------------------
//      | 1/2 1/2    1/2 1/2
// This is the method of Stoermer and Verlet, V = v + h/2 f(q, V), q+ = q exp(h V), v+ = V + h/2 f(q+, V).
// It acts on the index-1 form, whose velocities are not the momenta of [jay1996]: symmetric, and not symplectic.
// Sources: [hairer2006, Sec. II.2.2], centre [zanna2001].
#include "methods/rkmk/implicit_rkmk.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

static const ImplicitTableau lobatto3ab2{
    .a = {{0, 0}, {{1, 2}, {1, 2}}},
    .b = {{1, 2}, {1, 2}},
    .c = {0, 1},
    .a_hat = {{{1, 2}, 0}, {{1, 2}, 0}},
    .around_middle = true,
};

KREISEL_METHOD(implicit_rkmk(lobatto3ab2),
               {.name = "rkmk/lobatto3ab2",
                .order = 2,
                .cites = {"hairer2006", "munthekaas1999", "zanna2001"},
                .summary = "partitioned Munthe-Kaas lift of the Lobatto IIIA-IIIB pair with 2 stages, symmetric",
                .variable_cost = true,
                .form = Form::implicit,
                .preserves = {{Property::symmetric, Domain::autonomous}}});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
