// SPDX-License-Identifier: BSD-3-Clause
//
// Robots from URDF files as mechanisms: the parameters of the problem multibody.
#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace kreisel::urdf {

/// Where a robot starts: coordinates of joints (rad, m) and their rates, 0 where none is given.
struct Start {
    std::map<std::string, double> positions, rates;
    std::optional<bool> holds_root;  ///< whether the root is the ground; by default where it has no mass
};

struct Mechanism {
    nlohmann::json parameters;         ///< bodies, joints, forces
    std::vector<std::string> remarks;  ///< what the file has and the mechanism has not
};

/// Links that fixed joints connect make one body, with the name of the link nearest to the root; links without mass
/// must be fixed to others. Damping of joints becomes a damper or a rotational damper. Bodies have the shape of their
/// geometry if it is a box, a cylinder or a sphere about their mass centre; else, where the homogeneous solid would be
/// far larger than the distances of their joints, that of a cylinder about their joint's axis. Throws UsageError with
/// the place of everything that cannot be taken; FileError if the file cannot be read.
Mechanism read_mechanism(const std::filesystem::path& file, const Start& start);

}  // namespace kreisel::urdf
