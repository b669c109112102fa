// SPDX-License-Identifier: BSD-3-Clause
#include "lie/so3.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// Unit quaternion (w, x, y, z), w >= 0, by the branch whose pivot is largest: no cancellation at any angle. NaN where
/// R is too far from a rotation to have one.
Eigen::Matrix<Real, 4, 1> quaternion(const Mat3& R) {
    Eigen::Matrix<Real, 4, 1> q;
    const Real trace = R.trace();
    int i = 0;
    if (R(1, 1) > R(0, 0)) i = 1;
    if (R(2, 2) > R(i, i)) i = 2;
    if (trace >= R(i, i)) {
        q << 1 + trace, R(2, 1) - R(1, 2), R(0, 2) - R(2, 0), R(1, 0) - R(0, 1);
    } else {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        q[0] = R(k, j) - R(j, k);
        q[1 + i] = 1 + R(i, i) - R(j, j) - R(k, k);
        q[1 + j] = R(i, j) + R(j, i);
        q[1 + k] = R(i, k) + R(k, i);
    }
    const Real norm = sqrt(q.squaredNorm());
    q /= isfinite(norm) ? norm : Real(0);
    if (q[0] < 0) q = -q;
    return q;
}

}  // namespace

Vec3 SO3::log(const Mat3& R) {
    const auto q = quaternion(R);
    const Vec3 axis = q.tail<3>();
    const Real sine = sqrt(axis.squaredNorm());  // sin(t/2)
    if (sine == 0) return Vec3::Zero();
    return (2 * atan2(sine, q[0]) / sine) * axis;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
