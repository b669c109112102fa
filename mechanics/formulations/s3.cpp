// SPDX-License-Identifier: BSD-3-Clause
//
// S3: bodies that each turn about a fixed point, q = a in S^3, a unit quaternion, v = omega: SO3 on its double
// covering.
#include "lie/s3.hpp"
#include "mechanics/formulations/pivoted_bodies.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

struct S3Coordinates {
    static constexpr const char* name = "S3";
    using Factor = S3;
    using Rotations = QuaternionStorage;
};

KREISEL_FORMULATION(pivoted_formulation<S3Coordinates>(
    {.summary = "unit quaternions of bodies that turn about a fixed point: q = a, v = omega; no constraint is left",
     .place = 5,
     .cites = {"celledonifasso2008"}}));

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
