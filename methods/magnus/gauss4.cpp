// SPDX-License-Identifier: BSD-3-Clause
//
// Explicit Magnus method of order 4 for nonlinear equations Y' = A(t, Y) Y by the Gauss points c = 1/2 -+ sqrt(3)/6:
// the iterates Omega_1, Omega_2, Omega_3 of the source at both points, each through the slopes of the one before it,
// and Omega_4 at h. With k_i = h A(t_n + c_i h, exp(u_i) Y_n) and c_2 = c_4 = c_6, c_3 = c_5 = c_7 the Gauss points:
//   u_2 = c_2 k_1,   u_3 = c_3 k_1                                                 (Omega_1, frozen),
//   u_4, u_5: the weights of Gauss' method of two stages on k_2, k_3               (Omega_2),
//   u_6, u_7: the integrals to c of the parabola through k_1, k_4, k_5 at 0, c_4, c_5, which two points alone do not
//             give to h^3, less c^3 sqrt(3)/12 [k_1, k_5 - k_4]                    (Omega_3),
//   v = (k_6 + k_7)/2 - sqrt(3)/12 [k_6, k_7]                                      (Omega_4).
// Source: iterates [casasiserles2006], last line [hairer2006, Sec. IV.7.4]; the quadrature of the stages is ours.
#include "methods/rkmk/few_commutators.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

static const FewCommutatorsScheme magnus_gauss4{
    .stages = {{},
               {.weights = {"0.21132486540518711774542560974902127217619912"}},
               {.weights = {"0.78867513459481288225457439025097872782380088"}},
               {.weights = {0, {1, 4}, "-0.03867513459481288225457439025097872782380088"}},
               {.weights = {0, "0.53867513459481288225457439025097872782380088", {1, 4}}},
               {.weights = {"0.09622504486493762741819146341699290927460029", 0, 0,
                            "0.11855414423419785295757093495817021202936652",
                            "-0.00345432369394836263033678862614184912776769"},
                .brackets = {{1, 4, "0.00136216960212938805959957655915011875575289"},
                             {1, 5, "-0.00136216960212938805959957655915011875575289"}}},
               {.weights = {"-0.09622504486493762741819146341699290927460029", 0, 0,
                            "0.67012099036061502929700345529280851579443435",
                            "0.21477918909913548037576239837516312130396681"},
                .brackets = {{1, 4, "0.07080661404657383250404402100359456320019733"},
                             {1, 5, "-0.07080661404657383250404402100359456320019733"}}}},
    .result = {.weights = {0, 0, 0, 0, 0, {1, 2}, {1, 2}},
               .brackets = {{6, 7, "-0.14433756729740644112728719512548936391190044"}}},
};

KREISEL_METHOD(few_commutators(magnus_gauss4),
               {.name = "magnus/gauss4",
                .order = 4,
                .cites = {"casasiserles2006", "hairer2006"},
                .summary = "explicit Magnus method of order 4 for nonlinear equations, two Gauss points"});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
