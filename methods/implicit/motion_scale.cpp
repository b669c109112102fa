// SPDX-License-Identifier: BSD-3-Clause
#include "methods/implicit/motion_scale.hpp"

#include <algorithm>

namespace kreisel {
inline namespace KREISEL_PRECISION {

MotionScale::MotionScale(System& system)
    : system_(system),
      axes_(dynamic_cast<const SpaceAxes*>(&system)),
      weights_(VecX::Ones(system.velocities())),
      mobility_(weights_),
      blocks_(static_cast<std::size_t>(system.velocities() * system.mass_block())),
      applied_(weights_),
      gyroscopic_(weights_) {}

void MotionScale::weigh(const Real* q) {
    if (known_ && system_.mass_is_constant()) return;
    known_ = true;
    system_.mass(q, blocks_.data());
    const auto rows = static_cast<std::size_t>(system_.mass_block());
    for (Eigen::Index i = 0; i < weights_.size(); ++i) {
        const auto k = static_cast<std::size_t>(i);
        weights_[i] = sqrt(blocks_[k * rows + k % rows] / blocks_[0]);
        mobility_[i] = 1 / (weights_[i] * blocks_[0]);
    }
}

void MotionScale::to_space(const Real* q, const Real* v, Real* turned) const {
    KREISEL_ELEMENTWISE
    for (Eigen::Index i = 0; i < weights_.size(); ++i) turned[i] = weights_[i] * v[i];
    if (axes_) axes_->to_space_axes(q, turned, turned);
}

void MotionScale::from_space(const Real* q, const Real* turned, Real* v) const {
    axes_ ? axes_->from_space_axes(q, turned, v) : void(std::copy_n(turned, weights_.size(), v));
    KREISEL_ELEMENTWISE
    for (Eigen::Index i = 0; i < weights_.size(); ++i) v[i] /= weights_[i];
}

Real MotionScale::of_velocity(const Real* v) const {
    Real size = 0;
    for (Eigen::Index i = 0; i < weights_.size(); ++i) size = max(size, Real(weights_[i] * abs(v[i])));
    return size;
}

Real MotionScale::of_impulse(const Real* p) const {
    Real size = 0;
    for (Eigen::Index i = 0; i < weights_.size(); ++i) size = max(size, Real(mobility_[i] * abs(p[i])));
    return size;
}

Real MotionScale::of_motion(const Real& t, const Real& h, const Real* y) {
    const Real* v = system_.v(y);
    system_.applied_force(t, y, v, applied_.data());
    system_.gyroscopic_force(y, v, gyroscopic_.data());
    applied_.array() = abs(h) * (applied_.array().abs() + gyroscopic_.array().abs());
    return max(of_velocity(v), of_impulse(applied_.data()));
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
