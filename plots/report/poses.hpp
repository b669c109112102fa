// SPDX-License-Identifier: BSD-3-Clause
//
// Poses over time as few bytes.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "records/reading/trajectory_table.hpp"
#include "records/results.hpp"

namespace kreisel {

/// The unit quaternion (w, x, y, z) of a rotation, row by row, with the sign nearer to `near`.
std::array<double, 4> quaternion_of(const std::array<double, 9>& R, const std::array<double, 4>& near = {1, 0, 0, 0});

/// Indices of at most `most` of `samples` samples: every k-th, and the last.
std::vector<std::size_t> thinned(std::size_t samples, std::size_t most);

/// The names of the bodies whose positions a trajectory holds.
std::vector<std::string> bodies_in(const TrajectoryTable& trajectory);

/// Of some instants of some bodies, as little-endian numbers in base64. Throws std::out_of_range where a column is
/// missing.
struct PackedPoses {
    std::string t, x, q, v;  ///< 64, 64, 16 and 32 bits a number; q and v empty where the trajectory does not hold them
};
PackedPoses packed_poses(const TrajectoryTable& trajectory, const std::vector<std::string>& bodies,
                         const std::vector<std::size_t>& instants);

}  // namespace kreisel
