// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "engine/engine.hpp"

namespace kreisel {

/// A number of a state as JSON: bare if it is the shortest decimal of a double, else in quotes with all its digits.
std::string json_digits(const Number& number);

/// {"t": 1, "bodies": [{"name": "top", "x": [...], "R": [...], "v": [...], "omega": [...]}], "turns": {...}}
std::string json_begin(const BeginState& begin);

}  // namespace kreisel
