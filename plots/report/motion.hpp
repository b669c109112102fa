// SPDX-License-Identifier: BSD-3-Clause
//
// The motions of a folder as data of the page: poses of the bodies over time, and what to draw at them.
#pragma once

#include <filesystem>
#include <string>

#include "records/results.hpp"

namespace kreisel {

/// Most of a motion that is shown: instants and bodies.
inline constexpr std::size_t most_instants = 500, most_bodies = 100;

/// Bytes for all motions of a page, of which so many are taken by data other than motions: less where these are many.
std::size_t room_for_motion(std::size_t others);

/// {"mechanisms": [...], "cells": [...], "remarks": [what is thinned or left out]}. A cell has its "row" in the table
/// of all cells, its "mechanism" (null: not known), the names of its "bodies", and in base64, bodies within instants:
/// times "t" and positions "x" (m; 64 bits, so that the distance of two cells may be as small as they tell), rotations
/// "q" as quaternions (w, x, y, z) times 32767 (16 bits; null where samples hold none), velocities "v" (m/s; 32 bits;
/// null likewise), and the "forces" of links and those "applied" (plots/report/forces.hpp). A mechanism has the shapes
/// of its "bodies" and "links"; see plots/mechanism/shape.hpp and engine/geometry.hpp. `room`: what it may take, bytes.
std::string report_motion(const Results& results, const std::filesystem::path& folder, std::size_t room);

}  // namespace kreisel
