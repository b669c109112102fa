// SPDX-License-Identifier: BSD-3-Clause
//
// The closed form of the free body in double, callable from a program that is linked with the quad objects.
// Nothing here may mention Real: its meaning differs in the other files of this suite.
#pragma once

#include "mechanics/model/data.hpp"

namespace reference_tests {

struct DoubleRotation {
    kreisel::Matrix3 R;  // row by row
    kreisel::Vector3 omega;
};

DoubleRotation free_rotation_in_double(const kreisel::Matrix3& J, const kreisel::Matrix3& R0,
                                       const kreisel::Vector3& omega, double t);

}  // namespace reference_tests
