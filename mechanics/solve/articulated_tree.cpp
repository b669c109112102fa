// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/solve/articulated_tree.hpp"

#include <utility>

#include "mechanics/solve/forest.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

constexpr int none = TreeNode::none;

/// Hangs the node by its joint, as the first child of its parent.
void hang(TreeNode& node, int parent, const Model& model, std::vector<TreeNode>& earlier) {
    const Joint& joint = model.joints[static_cast<std::size_t>(node.joint)];
    const bool second = joint.second == node.body;
    const Vec3 &own = second ? joint.r_second : joint.r_first, &others = second ? joint.r_first : joint.r_second;
    node.sign = second ? 1 : -1;
    node.d = -own;
    node.J = inertia_about(model.bodies[static_cast<std::size_t>(node.body)], node.d);
    if (parent == none) return;
    TreeNode& above = earlier[static_cast<std::size_t>(parent)];
    node.s = others + above.d;
    node.sibling = std::exchange(above.child, static_cast<int>(earlier.size()));
}

}  // namespace

std::vector<TreeNode> articulated_tree(const Model& model) {
    std::vector<TreeNode> nodes;
    for (const Branch& branch : branches(model)) {
        const Body& body = model.bodies[static_cast<std::size_t>(branch.body)];
        TreeNode node{.body = branch.body,
                      .joint = branch.joint,
                      .rooted = branch.parent == none,
                      .mass = body.mass,
                      .J = body.J};
        if (branch.joint != none) hang(node, branch.parent, model, nodes);
        nodes.push_back(node);
    }
    return nodes;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
