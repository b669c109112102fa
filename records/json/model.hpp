// SPDX-License-Identifier: BSD-3-Clause
//
// The entries of a mechanism as JSON. Internal to the writer.
#pragma once

#include <string>

#include "mechanics/model/data.hpp"

namespace kreisel {

/// As a config writes them, with every default that is a value; they read back to the same data.
std::string json_element(const BodyData& body);
std::string json_element(const JointData& joint);
std::string json_element(const ForceData& force);

}  // namespace kreisel
