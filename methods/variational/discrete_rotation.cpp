// SPDX-License-Identifier: BSD-3-Clause
#include "methods/variational/discrete_rotation.hpp"

#include <Eigen/LU>

#include "lie/so3.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

DiscreteRotation::DiscreteRotation(RotationDistance distance, const Mat3& J, const Mat3& J_inverse, const Vec3& p,
                                   const Real& h)
    : distance_(distance), J_(J), h_(h), hp_(h * p), u_(J_inverse * hp_) {}

bool DiscreteRotation::evaluate() {
    m_ = J_ * u_;
    const Vec3 um = u_.cross(m_);
    const Real s = u_.squaredNorm(), d = u_.dot(m_);
    r_ = m_ + um / 2 - hp_;
    slope_ = J_ + (hat(u_) * J_ - hat(m_)) / 2;
    const Vec3 um_2 = 2 * m_;  // the gradient of d
    switch (distance_) {
        case RotationDistance::exp: {
            if (!(s < 36)) return false;  // short of the pole at 2 pi
            const Real k = cotc(s);
            const Vec3 uum = u_.cross(um);  // d u - s m
            r_ += k * uum;
            slope_ += k * (u_ * um_2.transpose() - um_2 * u_.transpose() - s * J_);
            slope_ += 2 * cotc_ds(s) * uum * u_.transpose();
            slope_.diagonal().array() += k * d;
            return true;
        }
        case RotationDistance::cayley:
            r_ += d / 4 * u_;
            slope_ += u_ * um_2.transpose() / 4;
            slope_.diagonal().array() += d / 4;
            return true;
        case RotationDistance::matrix:
            r_ -= s / 4 * hp_;
            slope_ -= hp_ * u_.transpose() / 2;
            return true;
    }
    return false;
}

Status DiscreteRotation::solve(long& iterations) {
    constexpr int most_iterations = 40;
    Real before = 0;
    for (int i = 0; i < most_iterations; ++i, ++iterations) {
        if (!evaluate()) return isfinite(Real(u_.sum())) ? Status::newton_failed : Status::non_finite;
        const Vec3 correction = slope_.inverse() * r_;
        const Real size = correction.norm();
        if (!isfinite(size)) return isfinite(Real(hp_.sum())) ? Status::newton_failed : Status::non_finite;
        u_ -= correction;
        // What no longer decreases is round-off, or there is no solution.
        const bool stands = i > 0 && 2 * size > before;
        if (size <= epsilon * u_.norm() || (stands && size <= 64 * epsilon * u_.norm())) {
            m_ = J_ * u_;
            return Status::ok;
        }
        before = size;
    }
    return Status::newton_failed;
}

Vec3 DiscreteRotation::gained_momentum() const {
    const Real scale = distance_ == RotationDistance::matrix ? Real(h_ * (1 + u_.squaredNorm() / 4)) : h_;
    return m_.cross(u_) / scale;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
