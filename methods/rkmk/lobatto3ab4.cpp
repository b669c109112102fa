// SPDX-License-Identifier: BSD-3-Clause
//
// Partitioned Munthe-Kaas lift of the Lobatto IIIA-IIIB pair with 4 stages, order 6: positions by IIIA, velocities by
// IIIB, which is a^_ij = b_j (1 - a_ji / b_i), in coordinates around the middle of the step.
//   (5 -+ S)/10, S = sqrt(5), are the inner nodes, b = (1, 5, 5, 1)/12; IIIA, rows 2 and 3, and IIIB, columns 2 and 3:
//     (11 + S)/120 (25 -  S)/120   (25 - 13 S)/120 (-1 + S)/120       (-1 - S)/24      (-1 + S)/24
//     (11 - S)/120 (25 + 13 S)/120 (25 +  S)/120   (-1 - S)/120       (25 + S)/120    (25 - 13 S)/120
//                                                                    (25 + 13 S)/120   (25 - S)/120
//                                                                     (11 - S)/24      (11 + S)/24
// It acts on the index-1 form, whose velocities are not the momenta of [jay1996]: symmetric, and not symplectic.
// Sources: [hairer1996, Sec. IV.5], [hairer2006, Sec. II.2.2], centre [zanna2001].
#include "methods/rkmk/implicit_rkmk.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

static const ImplicitTableau lobatto3ab4{
    .a = {{0, 0, 0, 0},
          {"0.1103005664791649141367431139060939686286718197", "0.1896994335208350858632568860939060313713281803",
           "-0.03390736422914388377766048077922159217273365562", "0.01030056647916491413674311390609396862867181966"},
          {"0.07303276685416841919659021942723936470466151367", "0.4505740308958105504443271474458882588394003223",
           "0.2269672331458315808034097805727606352953384863", "-0.02696723314583158080340978057276063529533848633"},
          {{1, 12}, {5, 12}, {5, 12}, {1, 12}}},
    .b = {{1, 12}, {5, 12}, {5, 12}, {1, 12}},
    .c = {0, "0.276393202250021030359082633126872376455938164", "0.723606797749978969640917366873127623544061836", 1},
    .a_hat = {{{1, 12},
               "-0.1348361657291579040170489028638031764766924317",
               "0.05150283239582457068371556953046984314335909832",
               0},
              {{1, 12},
               "0.2269672331458315808034097805727606352953384863",
               "-0.03390736422914388377766048077922159217273365562",
               0},
              {{1, 12},
               "0.4505740308958105504443271474458882588394003223",
               "0.1896994335208350858632568860939060313713281803",
               0},
              {{1, 12},
               "0.3651638342708420959829510971361968235233075683",
               "0.5515028323958245706837155695304698431433590983",
               0}},
    .around_middle = true,
};

KREISEL_METHOD(implicit_rkmk(lobatto3ab4),
               {.name = "rkmk/lobatto3ab4",
                .order = 6,
                .cites = {"hairer1996", "hairer2006", "munthekaas1999", "zanna2001"},
                .summary = "partitioned Munthe-Kaas lift of the Lobatto IIIA-IIIB pair with 4 stages, symmetric",
                .variable_cost = true,
                .form = Form::implicit,
                .preserves = {{Property::symmetric, Domain::autonomous}}});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
