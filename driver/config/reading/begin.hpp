// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "driver/config/catalogue.hpp"
#include "records/json/node.hpp"

namespace kreisel {

/// What a number of a state is beside a JSON number: in quotes with the digits that a quad run writes.
inline constexpr const char* digits_pattern = "^-?[0-9]+([.][0-9]+)?([eE][+-]?[0-9]+)?$";
inline constexpr const char* positive_digits_pattern = "^[0-9]+([.][0-9]+)?([eE][+-]?[0-9]+)?$";

/// Reads "begin" of "time", the state itself (driver/config/composition/begin_file.hpp puts that of a sample there).
/// Null after an error.
std::shared_ptr<const BeginState> read_begin(const Node& node);

}  // namespace kreisel
