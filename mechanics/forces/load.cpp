// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/forces/load.hpp"

#include "mechanics/forces/entry.hpp"
#include "mechanics/forces/forces.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// Without force and torque.
Load modulated(const ForceEntry& entry) {
    return {.body = entry.second,
            .axes = entry.body_axes ? Load::Axes::body : Load::Axes::space,
            .amplitude = entry.amplitude,
            .frequency = entry.frequency};
}

void read_force(const ForceEntry& entry, Forces& forces) {
    Load load = modulated(entry);
    load.force = entry.value, load.point = entry.point;
    forces.loads.push_back(load);
}

void read_torque(const ForceEntry& entry, Forces& forces) {
    Load load = modulated(entry);
    load.torque = entry.value;
    forces.loads.push_back(load);
}

}  // namespace

KREISEL_FORCE("force", read_force);
KREISEL_FORCE("torque", read_torque);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
