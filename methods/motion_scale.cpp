// SPDX-License-Identifier: BSD-3-Clause
#include "methods/motion_scale.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

MotionScale::MotionScale(System& system)
    : system_(system),
      root_mass_(static_cast<std::size_t>(system.velocities())),
      velocities_(root_mass_.size()),
      blocks_(root_mass_.size() * static_cast<std::size_t>(system.mass_block())),
      applied_(root_mass_.size()),
      gyroscopic_(root_mass_.size()) {}

void MotionScale::measure(const Real& t, const Real& h, const Real* y) {
    const Real* v = y + system_.group().size();
    system_.mass(y, blocks_.data());
    system_.applied_force(t, y, v, applied_.data());
    system_.gyroscopic_force(y, v, gyroscopic_.data());
    const auto rows = static_cast<std::size_t>(system_.mass_block());
    size_ = 0;
    for (std::size_t i = 0; i < root_mass_.size(); ++i) {
        root_mass_[i] = sqrt(blocks_[i * rows + i % rows]);
        const Real force = abs(applied_[i]) + abs(gyroscopic_[i]);
        size_ = max(size_, max(Real(root_mass_[i] * abs(v[i])), Real(abs(h) * force / root_mass_[i])));
    }
    if (!(size_ > 0)) size_ = 1;
    for (std::size_t i = 0; i < root_mass_.size(); ++i) velocities_[i] = size_ / root_mass_[i];
}

Real MotionScale::impulse(const MatX& C, Eigen::Index row) const {
    Real complement = 0;
    for (std::size_t i = 0; i < root_mass_.size(); ++i) {
        const Real entry = C(row, static_cast<Eigen::Index>(i)) / root_mass_[i];
        complement += entry * entry;
    }
    return size_ / sqrt(complement);
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
