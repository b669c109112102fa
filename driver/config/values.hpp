// SPDX-License-Identifier: BSD-3-Clause
//
// What values are written as, and how vectors and matrices are read. Internal to the reader.
#pragma once

#include <optional>
#include <string>

#include "driver/config/reading/printed.hpp"
#include "problems/description.hpp"
#include "records/json/node.hpp"

namespace kreisel {

/// How a parameter of this kind is written, in words.
std::string expectation(ParameterKind kind);

/// Vectors, matrices row by row, rotation matrices, and inertias (three numbers or a symmetric matrix).
std::optional<Vector3> read_vector(const Node& node, const std::string& expected);
std::optional<Matrix3> read_matrix(const Node& node, const std::string& expected);
std::optional<Matrix3> read_rotation(const Node& node, const PrintedNumbers& printed);
std::optional<Matrix3> read_inertia(const Node& node, const PrintedNumbers& printed);

}  // namespace kreisel
