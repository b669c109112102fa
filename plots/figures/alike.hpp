// SPDX-License-Identifier: BSD-3-Clause
//
// Panels that show the same.
#pragma once

#include <vector>

#include "plots/figures/panels.hpp"

namespace kreisel {

/// Whether two panels could be told apart by their titles alone: their axes and legends are the same, and no point of
/// a curve is farther from that of the other panel than half a mark, 1/80 of an axis.
bool look_alike(const Panel& a, const Panel& b);

/// Of titled panels that look alike the first, under the titles of all: "SO3, SE3".
std::vector<Panel> each_look_once(std::vector<Panel> panels);

}  // namespace kreisel
