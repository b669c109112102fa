// SPDX-License-Identifier: BSD-3-Clause
//
// Joints with prescribed coordinates: what a joint leaves free about or along its axis may be given as a function of
// time. Each prescribed coordinate adds a row `turn` or `shift` to the joint's recipe and takes the free motion away;
// all else follows from the recipe again.
#pragma once

#include "mechanics/parts/joint_type.hpp"

namespace kreisel {

/// Coordinates of a joint that are prescribed.
struct Drive {
    bool turn = false, shift = false;
};

/// Those that a joint lets prescribe: it turns about its axis, or slides along it.
Drive drivable(const JointRecipe& recipe);
/// A joint with these coordinates prescribed, itself if they are none. Its name is "revolute with driven turn", the
/// name of its element remains "revolute". Throws std::invalid_argument if the joint has no such coordinate.
JointType driven(JointType type, const Drive& drive);
/// All joints that have a prescribed coordinate.
const std::vector<JointKind>& driven_kinds();

}  // namespace kreisel
