// SPDX-License-Identifier: BSD-3-Clause
//
// A heavy top without symmetry: three different moments, products of inertia, a lever not along a principal axis.
// Energy and the vertical angular momentum are the only first integrals. The data are our own: those of the acceptance
// problem forced_heavy_top with constant gravity.
#include "problems/top.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

KREISEL_PROBLEM(top, {.name = "asymmetric_heavy_top",
                      .summary = "asymmetric body on a spherical joint in constant gravity",
                      .cites = {},
                      .parameters = top_parameters(15, {0.3, 0.05, -0.02, 0.05, 0.5, 0.03, -0.02, 0.03, 0.4},
                                                   {0.2, 1, -0.3}, {0.5, 3, -0.4})});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
