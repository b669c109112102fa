// SPDX-License-Identifier: BSD-3-Clause
//
// How the bodies, joints and forces of a mechanism are read. Internal to the reader.
#pragma once

#include <optional>

#include "driver/config/reading/printed.hpp"
#include "problems/description.hpp"
#include "records/json/node.hpp"

namespace kreisel {

/// Lists of bodies, joints and forces; the types and keys are those of records/json/model_keys.hpp.
std::optional<ParameterValue> parse_bodies(const Node& node, const PrintedNumbers& printed);
std::optional<ParameterValue> parse_joints(const Node& node);
std::optional<ParameterValue> parse_forces(const Node& node, const PrintedNumbers& printed);

}  // namespace kreisel
