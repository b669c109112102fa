// SPDX-License-Identifier: BSD-3-Clause
//
// A forest of spherical joints as the recursions for articulated bodies walk through it
// (mechanics/formulations/spherical_bodies.hpp): parents before their children.
#pragma once

#include <vector>

#include "mechanics/model/model.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// A body, its joint and its place in the tree. All vectors and J are in body axes.
struct TreeNode {
    static constexpr int none = -1;

    int body = none;
    int joint = none;                         ///< to the parent or the ground; none for a free body
    int sign = 1;                             ///< of the multipliers: 1 where the body is the second of its joint
    int child = none, sibling = none;         ///< nodes: its first child, the next child of its parent
    bool rooted = true;                       ///< has no parent body: hangs on the ground or is free
    Real mass = 1;                            ///< kg
    Vec3 d = Vec3::Zero(), s = Vec3::Zero();  ///< from its joint to its mass centre; from its parent's joint to its own
    Mat3 J = Mat3::Identity();                ///< inertia about the joint, of a free body about the mass centre
};

/// All bodies of a model whose joints are spherical and form no loop.
std::vector<TreeNode> articulated_tree(const Model& model);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
