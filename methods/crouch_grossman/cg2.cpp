// SPDX-License-Identifier: BSD-3-Clause
//
// Crouch-Grossman method on Heun's tableau; here the order of the two final factors matters.
//   0 |
//   1 |  1
//   --+----------
//     | 1/2  1/2
// Source: [crouchgrossman1993].
#include "methods/crouch_grossman/crouch_grossman.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

static const Tableau cg2{
    .a = {{}, {1}},
    .b = {{1, 2}, {1, 2}},
};

KREISEL_METHOD(crouch_grossman(cg2), {.name = "crouch_grossman/cg2",
                                      .order = 2,
                                      .cites = {"crouchgrossman1993"},
                                      .summary = "Crouch-Grossman method of order 2 with two stages"});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
