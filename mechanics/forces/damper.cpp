// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/forces/damper.hpp"

#include "mechanics/forces/entry.hpp"
#include "mechanics/forces/forces.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

WrenchPair Damper::exerted(const Motion& one, const Motion& other) const {
    const Vec3 P = other.point(r_second);
    const Vec3 slip = other.point_velocity(r_second) - one.point_velocity(one.R.transpose() * (P - one.x));
    return {force_through(one, damping * slip, P), force_at(other, -damping * slip, r_second)};
}

namespace {

void read_damper(const ForceEntry& entry, Forces& forces) {
    forces.dampers.push_back(
        {.first = entry.first, .second = entry.second, .r_second = entry.r_second, .damping = entry.damping});
}

}  // namespace

KREISEL_FORCE(Damper::type, read_damper);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
