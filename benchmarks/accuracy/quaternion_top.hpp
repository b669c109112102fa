// SPDX-License-Identifier: BSD-3-Clause
//
// The top reduced by hand: y = (q, omega), q = (w, x, y, z) from body to space, omega in body axes, and no pivot any
// more. With J_O about the pivot and gamma = R^T e_z,
//   q' = 1/2 q (0, omega),   J_O omega' = -omega x J_O omega - m g (0, 1, 0) x gamma.
// J_O is diagonal. That omega_y is constant, and other constants of motion, are not used.
#pragma once

#include "benchmarks/accuracy/contender.hpp"

namespace accuracy {

using State = std::array<double, 7>;

inline constexpr State quaternion_start = {1, 0, 0, 0, spin[0], spin[1], spin[2]};

inline void quaternion_top(const double* y, double* dy) {
    constexpr double J1 = inertia[0] + mass, J2 = inertia[1], J3 = inertia[2] + mass;
    constexpr double a1 = (J2 - J3) / J1, a2 = (J3 - J1) / J2, a3 = (J1 - J2) / J3;
    constexpr double weight1 = mass * gravity / J1, weight3 = mass * gravity / J3;
    const double w = y[0], x = y[1], u = y[2], z = y[3];
    const double half1 = y[4] / 2, half2 = y[5] / 2, half3 = y[6] / 2;
    dy[0] = -(x * half1 + u * half2 + z * half3);
    dy[1] = w * half1 + u * half3 - z * half2;
    dy[2] = w * half2 + z * half1 - x * half3;
    dy[3] = w * half3 + x * half2 - u * half1;
    dy[4] = a1 * y[5] * y[6] - weight1 * (1 - 2 * (x * x + u * u));
    dy[5] = a2 * y[6] * y[4];
    dy[6] = a3 * y[4] * y[5] + 2 * weight3 * (x * z - w * u);
}

/// The lever in space axes: the second column of R, of q made unit.
inline std::array<double, 3> quaternion_position(const double* y) {
    const double w = y[0], x = y[1], u = y[2], z = y[3], n = w * w + x * x + u * u + z * z;
    return {2 * (x * u - w * z) / n, (w * w - x * x + u * u - z * z) / n, 2 * (u * z + w * x) / n};
}

}  // namespace accuracy
