// SPDX-License-Identifier: BSD-3-Clause
//
// S3xR3: q = (x, a) in R^3 x S^3 with the unit quaternion a, v = (x', omega): SO3xR3 on its double covering.
#include "lie/pair.hpp"
#include "lie/rn.hpp"
#include "lie/s3.hpp"
#include "mechanics/formulations/body_formulation.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

struct S3xR3Coordinates : SpaceVelocity {
    using Factor = Pair<Rn<3>, S3>;
    using Rotations = QuaternionStorage;
};

KREISEL_FORMULATION(body_formulation<S3xR3Coordinates>(
    {.name = "S3xR3",
     .summary = "unit quaternion and position of each body apart: q = (x, a), v = (x', omega); joints are constraints",
     .place = 3,
     .cites = {"muellerterze2014", "terze2016"}}));

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
