// SPDX-License-Identifier: BSD-3-Clause
#include "methods/velocity_scale.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

VelocityScale::VelocityScale(System& system)
    : system_(system),
      blocks_(static_cast<std::size_t>(system.velocities() * system.mass_block())),
      applied_(static_cast<std::size_t>(system.velocities())),
      gyroscopic_(applied_.size()) {}

void VelocityScale::measure(const Real& t, const Real& h, const Real* y) {
    const Real* v = y + system_.group().size();
    system_.mass(y, blocks_.data());
    system_.applied_force(t, y, v, applied_.data());
    system_.gyroscopic_force(y, v, gyroscopic_.data());
    const auto rows = static_cast<std::size_t>(system_.mass_block());
    mass_ = 0;
    Real speed = 0, force = 0;
    for (std::size_t i = 0; i < applied_.size(); ++i) {
        mass_ = max(mass_, Real(abs(blocks_[i * rows + i % rows])));
        speed = max(speed, Real(abs(v[i])));
        force = max(force, Real(abs(applied_[i]) + abs(gyroscopic_[i])));
    }
    velocity_ = max(speed, Real(abs(h) * force / mass_));
    if (!(velocity_ > 0)) velocity_ = 1;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
