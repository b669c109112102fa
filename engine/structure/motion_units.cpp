// SPDX-License-Identifier: BSD-3-Clause
#include "engine/structure/motion_units.hpp"

#include <algorithm>

namespace kreisel {
inline namespace KREISEL_PRECISION {

MotionUnits::MotionUnits(System& system, const Real& length)
    : system_(system),
      length_(length > 0 ? length : Real(1)),
      y_(static_cast<std::size_t>(system.state_group().size())),
      dv_(static_cast<std::size_t>(system.velocities())),
      bodies_(static_cast<std::size_t>(system.bodies())) {}

Real MotionUnits::operator()(const Real* q, const Real* v) {
    std::copy_n(q, system_.group().size(), y_.data());
    std::copy_n(v, system_.velocities(), system_.v(y_.data()));
    system_.read(y_.data(), bodies_.data());
    Real size = 0;
    for (const BodyState& body : bodies_) size = max(size, max(Real(body.omega.norm()), Real(body.v.norm() / length_)));
    return size;
}

Real MotionUnits::rate(const Real& t, const Real& h, const Real* y) {
    const Real* v = system_.v(y);
    if (system_.accelerations(t, y, v, dv_.data(), nullptr) != Status::ok) return 0;
    const Real rate = max((*this)(y, v), Real(sqrt((*this)(y, dv_.data()))));
    return rate > 0 ? rate : Real(1 / abs(h));
}

Real MotionUnits::remoteness(const Real* y) {
    system_.read(y, bodies_.data());
    Real distance = 0;
    for (const BodyState& body : bodies_) distance = max(distance, Real(body.x.norm() / length_));
    return 1 + distance;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
