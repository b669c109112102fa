// SPDX-License-Identifier: BSD-3-Clause
//
// The shape of a figure in a config.
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace kreisel {

/// JSON Schema (draft-07) of one figure: an object with the keys of one of the kinds.
nlohmann::ordered_json figure_schema();

}  // namespace kreisel
