// SPDX-License-Identifier: BSD-3-Clause
//
// SO3xR3: q = (x, R) in R^3 x SO(3), v = (x', omega). Translation in space axes, rotation in body axes.
#include "lie/pair.hpp"
#include "lie/rn.hpp"
#include "lie/so3.hpp"
#include "mechanics/formulations/body_formulation.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

struct SO3xR3Coordinates : SpaceVelocity {
    using Factor = Pair<Rn<3>, SO3>;
    using Rotations = MatrixStorage;
};

KREISEL_FORMULATION(body_formulation<SO3xR3Coordinates>(
    {.name = "SO3xR3",
     .summary = "rotation and position of each body apart: q = (x, R), v = (x', omega); joints are constraints",
     .place = 1,
     .cites = {"muellerterze2014", "terzezlatarmueller"}}));

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
