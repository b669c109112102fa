// SPDX-License-Identifier: BSD-3-Clause
//
// Kovalevskaya's top: principal moments A = B = 2 C about the fixed point, the mass centre in the plane of A and B. A
// fourth integral, K = (p^2 - q^2 - c gamma_1)^2 + (2 p q - c gamma_2)^2 with c = m g l/C, makes it integrable
// [audin1996, Sec. I.2]. m = 1 kg, A = B = 1, C = 0.5 kg m^2, l = 0.5 m along x: diag(1, 0.75, 0.25) about the mass
// centre, on which the triangle inequality holds with equality (a flat body), as l may be at most sqrt(C/(2 m)). The
// numbers are our own choice.
#include "problems/top.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

KREISEL_PROBLEM(top, {.name = "kovalevskaya_top",
                      .summary = "the heavy top of Kovalevskaya: A = B = 2 C, integrable",
                      .cites = {"audin1996"},
                      .parameters = top_parameters(1, diagonal(1, 0.75, 0.25), {0.5, 0, 0}, {1, 2, 0.5})});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
