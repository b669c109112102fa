// SPDX-License-Identifier: BSD-3-Clause
//
// SE3: q = (x, R) in SE(3), v = (V, omega) with V = R^T x'. All in body axes.
#include "lie/se3.hpp"
#include "mechanics/formulations/body_formulation.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

struct SE3Coordinates : BodyVelocity {
    using Factor = SE3;
    using Rotations = MatrixStorage;
};

KREISEL_FORMULATION(body_formulation<SE3Coordinates>(
    {.name = "SE3",
     .summary = "rigid displacement of each body: q = (x, R), v = (R^T x', omega); joints are constraints",
     .place = 2,
     .cites = {"bruelscardona2010", "bruels2012", "muellerterze2014choice"}}));

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
