// SPDX-License-Identifier: BSD-3-Clause
#include "tests/engine/free_bodies.hpp"

#include "problems/problem.hpp"

namespace reference_tests {

// With D2 = G^2 - 2 T I2 for moments I1 < I2 < I3: D2 < 0 circles about axis 1, D2 > 0 about axis 3, D2 = 0 is the
// separatrix: (1, 2, 2.25) with |omega1| : |omega3| = 3 : 4 has it exactly, for any omega2.
const std::vector<FreeBody>& free_bodies() {
    const Matrix3 asymmetric = diagonal(1, 2, 2.5), exact = diagonal(1, 2, 2.25), oblate = diagonal(1, 1, 1.5);
    const Matrix3 full = {0.3, 0.05, -0.02, 0.05, 0.5, 0.03, -0.02, 0.03, 0.4};
    static const std::vector<FreeBody> bodies = {
        {"about axis 1", asymmetric, {1.2, 0.3, 0.2}},
        {"about axis 1, reversed", asymmetric, {-1.2, 0.3, 0.2}},
        {"about axis 1, third component negative", asymmetric, {1.2, -0.3, -0.2}},
        {"about axis 3", asymmetric, {0.1, 0.3, 1.2}},
        {"about axis 3, reversed", asymmetric, {0.1, 0.3, -1.2}},
        {"about axis 3, first component negative", asymmetric, {-0.1, -0.3, 1.2}},
        {"axes in the order 2 3 1", diagonal(2, 2.5, 1), {0.3, 0.2, 1.2}},
        {"axes in the order 3 2 1", diagonal(2.5, 2, 1), {0.3, 0.2, 1.2}},
        {"separatrix ++", exact, {0.75, 0.5, 1}},
        {"separatrix +-", exact, {0.75, 0.5, -1}},
        {"separatrix -+", exact, {-0.75, 0.5, 1}},
        {"separatrix --", exact, {-0.75, -1, -1}},
        {"separatrix from its middle", exact, {0.75, 0, 1}},
        {"near the separatrix, D2 < 0", exact, {0.750001, 0.5, 1}},
        {"near the separatrix, D2 > 0", exact, {0.749999, 0.5, 1}},
        {"very near the separatrix", exact, {0.750000000001, 0.5, 1}},
        {"near the unstable rotation, D2 < 0", exact, {1e-8, 1, 1e-9}},
        {"near the unstable rotation, D2 > 0", exact, {1e-9, 1, 1e-8}},
        {"near the unstable rotation, one component", exact, {-1e-9, -1, 0}},
        {"oblate", oblate, {0.3, 0.2, 1.2}},
        {"oblate, reversed", oblate, {0.3, 0.2, -1.2}},
        {"oblate, almost about an equatorial axis", oblate, {1.3, 0.2, 0.01}},
        {"prolate", diagonal(1.5, 1.5, 1), {0.3, 0.2, 1.2}},
        {"prolate along the second axis", diagonal(1.5, 1, 1.5), {0.3, 1.2, 0.2}},
        {"almost oblate", diagonal(1, 1.000000001, 1.5), {0.3, 0.2, 1.2}},
        {"almost oblate, slow libration", diagonal(1, 1.000000001, 1.5), {1.3, 0.2, 1e-9}},
        {"spherical", diagonal(2, 2, 2), {0.3, 0.2, 1.2}, true},
        {"almost spherical", diagonal(2, 2.0000000001, 2.0000000003), {0.3, 0.2, 1.2}},
        {"fixed axis 1", asymmetric, {1, 0, 0}, true},
        {"fixed axis 2", asymmetric, {0, -1, 0}, true},
        {"fixed axis 3", asymmetric, {0, 0, -1}, true},
        {"almost fixed axis 1", asymmetric, {1, 1e-15, 0}},
        {"almost fixed axis 3", asymmetric, {0, 1e-15, 1}},
        {"at rest", asymmetric, {0, 0, 0}, true},
        {"full inertia, fast", full, {0.5, 3, -0.4}},
        {"full inertia, reversed", full, {-1, -0.3, 0.8}},
        {"published data [hairer2006, Fig. IV.1.1]",
         diagonal(2, 1, 0.6666666666666667),
         {0.2267980607127887, 0, 1.336811040092153}},
        {"rod", diagonal(0.0001, 1, 1.00005), {3, 1, 0.5}},
    };
    return bodies;
}

Real condition(const FreeBody& body, const Mat3& R0, const Real& t) {
    const Mat3 J = to_matrix(body.inertia);
    const Vec3 omega = to_vector(body.omega);
    const FreeRotation exact = free_rotation(J, R0, omega, t);
    const Real change = sqrt(epsilon) / 65536;
    Real sum = 1;
    for (int i = 0; i < 3; ++i) {
        const Vec3 w = omega + change * omega.norm() * Vec3::Unit(i);
        const Real moved = distance(free_rotation(J, R0, w, t), exact) / change;
        sum += moved * moved;
        for (int j = 0; j <= i; ++j) {
            Mat3 changed = J;
            changed(i, j) += change * J.norm();
            changed(j, i) = changed(i, j);
            const Real turned = distance(free_rotation(changed, R0, omega, t), exact) / change;
            sum += turned * turned;
        }
    }
    return sqrt(sum);
}

}  // namespace reference_tests
