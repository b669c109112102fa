// SPDX-License-Identifier: BSD-3-Clause
//
// The heavy top of the literature: a Lagrange top with axis y, on a spherical joint at the origin, in constant gravity.
// m = 15 kg, J = diag(0.234375, 0.46875, 0.234375) kg m^2 about the mass centre, lever (0, 1, 0) m, R(0) = I,
// omega(0) = (0, 150, -4.61538) rad/s; the last component truncates -60/13, and the choice moves x(2) by 3.8e-6 m.
// Sources: [bruelscardona2010], [terzezlatarmueller, Sec. 2.3]. The slow top has omega(0) = (0, 1.5, -0.0461538).
#include "problems/top.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

KREISEL_PROBLEM(top,
                {.name = "heavy_top",
                 .summary = "rigid body on a spherical joint in constant gravity; default: the literature's fast top",
                 .cites = {"bruelscardona2010", "terzezlatarmueller"},
                 .parameters = top_parameters(15, diagonal(0.234375, 0.46875, 0.234375), {0, 1, 0},
                                              {0, 150, -4.61538})});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
