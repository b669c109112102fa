// SPDX-License-Identifier: BSD-3-Clause
#include "methods/baseline/quaternion.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

void Quaternion::from_matrix(const Real* R, Real* q) const {
    const Real n = sqrt(R[0] * R[0] + R[1] * R[1] + R[2] * R[2]);
    const Real squares[4] = {n + R[0] + R[4] + R[8], n + R[0] - R[4] - R[8], n - R[0] + R[4] - R[8],
                             n - R[0] - R[4] + R[8]};
    int pivot = 0;
    for (int i = 1; i < 4; ++i)
        if (squares[i] > squares[pivot]) pivot = i;
    const Real wx = R[5] - R[7], wy = R[6] - R[2], wz = R[1] - R[3];
    const Real xy = R[1] + R[3], xz = R[2] + R[6], yz = R[5] + R[7];
    const Real rows[4][4] = {
        {squares[0], wx, wy, wz}, {wx, squares[1], xy, xz}, {wy, xy, squares[2], yz}, {wz, xz, yz, squares[3]}};
    const Real scale = 2 * sqrt(squares[pivot]);
    for (int i = 0; i < 4; ++i) q[i] = rows[pivot][i] / scale;
}

void Quaternion::to_matrix(const Real* q, Real* R) const {
    const Real w = q[0], x = q[1], y = q[2], z = q[3];
    R[0] = w * w + x * x - y * y - z * z, R[1] = 2 * (x * y + w * z), R[2] = 2 * (x * z - w * y);
    R[3] = 2 * (x * y - w * z), R[4] = w * w - x * x + y * y - z * z, R[5] = 2 * (y * z + w * x);
    R[6] = 2 * (x * z + w * y), R[7] = 2 * (y * z - w * x), R[8] = w * w - x * x - y * y + z * z;
}

bool Quaternion::derivative(const Real* q, const Real* o, const Real& /*h*/, Real* dq) const {
    dq[0] = -(q[1] * o[0] + q[2] * o[1] + q[3] * o[2]) / 2;
    dq[1] = (q[0] * o[0] + q[2] * o[2] - q[3] * o[1]) / 2;
    dq[2] = (q[0] * o[1] + q[3] * o[0] - q[1] * o[2]) / 2;
    dq[3] = (q[0] * o[2] + q[1] * o[1] - q[2] * o[0]) / 2;
    return true;
}

void DirectionQuaternion::to_matrix(const Real* q, Real* R) const {
    Quaternion::to_matrix(q, R);
    const Real n = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
    for (int i = 0; i < 9; ++i) R[i] /= n;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
