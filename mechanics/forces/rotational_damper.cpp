// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/forces/rotational_damper.hpp"

#include "mechanics/forces/entry.hpp"
#include "mechanics/forces/forces.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

WrenchPair RotationalDamper::exerted(const Motion& one, const Motion& other) const {
    const Vec3 torque = -damping * (other.R * other.omega - one.R * one.omega);
    return {{Vec3::Zero(), one.R.transpose() * -torque}, {Vec3::Zero(), other.R.transpose() * torque}};
}

namespace {

void read_rotational_damper(const ForceEntry& entry, Forces& forces) {
    forces.rotational_dampers.push_back({.first = entry.first, .second = entry.second, .damping = entry.damping});
}

}  // namespace

KREISEL_FORCE(RotationalDamper::type, read_rotational_damper);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
