// SPDX-License-Identifier: BSD-3-Clause
//
// SO3: bodies that each turn about a fixed point, q = R in SO(3), v = omega. Their joints are removed.
#include "lie/so3.hpp"
#include "mechanics/formulations/pivoted_bodies.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

struct SO3Coordinates {
    static constexpr const char* name = "SO3";
    using Factor = SO3;
    using Rotations = MatrixStorage;
};

KREISEL_FORMULATION(pivoted_formulation<SO3Coordinates>(
    {.summary = "bodies that turn about a fixed point: q = R, v = omega; no constraint is left",
     .place = 4,
     .cites = {"celledoniowren2003"}}));

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
