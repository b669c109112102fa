// SPDX-License-Identifier: BSD-3-Clause
//
// Quaternions q = (w, x, y, z) as coordinates of a rotation, q' = 1/2 q (0, omega); R column by column.
#pragma once

#include "methods/baseline/global_coordinates.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// R = R(q) is the quadratic form, which is |q|^2 times a rotation where the norm has drifted.
class Quaternion : public RotationCoordinates {
  public:
    int size() const final { return 4; }
    /// Inverse of the quadratic form, by the branch with the largest pivot. With n = |q|^2 (a column of R has norm n),
    /// 4 w^2 = n + trace and 4 x^2 = n + R_xx - R_yy - R_zz.
    void from_matrix(const Real* R, Real* q) const final;
    void to_matrix(const Real* q, Real* R) const override;
    bool derivative(const Real* q, const Real* o, const Real& h, Real* dq) const final;
};

/// R is the rotation of q/|q|: the norm means nothing, so that nothing has to be normalised between steps, which would
/// invalidate what a multistep method remembers.
class DirectionQuaternion final : public Quaternion {
  public:
    void to_matrix(const Real* q, Real* R) const override;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
