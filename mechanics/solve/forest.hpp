// SPDX-License-Identifier: BSD-3-Clause
//
// Joint graphs without loops.
#pragma once

#include <vector>

#include "mechanics/model/model.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Whether the joint graph, with the ground as a vertex, has no cycle. Then all rows are independent: in order from the
/// leaves inwards, each joint has a body that no later joint touches, and its rows are independent on that body.
bool is_forest(const Model& model);

/// For each joint a moving body that represents its mechanism: the same for joints that are linked through moving
/// bodies.
std::vector<std::size_t> islands(const Model& model);

/// A body in a forest, with the joint to its parent.
struct Branch {
    int body = ground;
    int parent = -1;  ///< position of the parent's branch; -1: the ground, or none
    int joint = -1;   ///< index of the joint to the parent or the ground; -1: a free body
};

/// All bodies of a forest, parents before their children.
std::vector<Branch> branches(const Model& model);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
