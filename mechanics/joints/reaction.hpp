// SPDX-License-Identifier: BSD-3-Clause
//
// Multipliers as users read them: the joint of each row of C, and the wrench of each joint.
#pragma once

#include "lie/linear.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Row `number` of a joint of the model, counted from 1. The multiplier of a row that compares directions is a torque
/// (N m), of any other row a force (N).
struct ConstraintRow {
    int joint = 0, number = 1;
    bool direction = false;
};

/// What a joint exerts on its second-named body, minus its part of C^T lambda: force (N) and torque (N m) in space
/// axes, the torque about the joint's point of that body (of a rolling joint, about the contact). The first-named body
/// gets the opposite about the same point. What keeps a prescribed coordinate is not part of these: the force (N) along
/// the axis of the second body on it, and the torque (N m) about that axis, 0 where nothing is prescribed.
struct JointReaction {
    Vec3 force = Vec3::Zero(), torque = Vec3::Zero();
    Real driving_force = 0, driving_torque = 0;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
