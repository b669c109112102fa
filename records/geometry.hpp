// SPDX-License-Identifier: BSD-3-Clause
//
// DIR/geometry.json: the mechanisms of the cells that keep samples. Its sum is in sums.sha256.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/geometry.hpp"
#include "records/json/model.hpp"

namespace kreisel {

inline constexpr const char* geometry_file = "geometry.json";

/// A mechanism and the cells that move it.
struct CellGeometry {
    std::vector<std::string> cells;  ///< hashes
    Geometry geometry;
    Shapes shapes = {};  ///< that the config gives
    bool operator==(const CellGeometry&) const = default;
};

/// {"mechanisms": [{"cells", "bodies": [{"name", "mass", "inertia", "shape"}], "links": [{"name", "type", "between",
/// "points", "axes", "length"}]}, ...]}, in SI units; see engine/geometry.hpp and records/json/model.hpp.
std::string geometry_text(const std::vector<CellGeometry>& mechanisms);

/// Writes the file and its sum. Throws FileError.
void write_geometry(const std::filesystem::path& folder, const std::vector<CellGeometry>& mechanisms);

/// None where there is no such file (older folders), or where it is damaged: that is said with the other damage.
std::vector<CellGeometry> read_geometry(const std::filesystem::path& folder);

/// The mechanism of a cell; null where it is not known.
const CellGeometry* geometry_of(const std::vector<CellGeometry>& mechanisms, const std::string& cell);

}  // namespace kreisel
