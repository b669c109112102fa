// SPDX-License-Identifier: BSD-3-Clause
//
// Marks by which lines of one colour are told apart where they coincide.
#pragma once

#include <cstddef>
#include <vector>

#include "plots/figures/panels.hpp"

namespace kreisel {

/// Of each curve of a panel, the points (their indices) that bear its mark: about six, at even distances along the x
/// axis, between those of the other curves with marks. None of a curve that is alone with its colour, whose dashes
/// suffice.
std::vector<std::vector<std::size_t>> offset_marks(const Panel& panel);

}  // namespace kreisel
