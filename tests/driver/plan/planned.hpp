// SPDX-License-Identifier: BSD-3-Clause
//
// Plans of configs that are written in a test, with the fake engine.
#pragma once

#include <string>

#include "driver/plan/plan.hpp"
#include "records/json/strict.hpp"
#include "tests/driver/command_line.hpp"

namespace kreisel::plan_tests {

inline Plan plan_from(const std::string& text) { return plan_of(parse_document("test.json", text), one_engine); }

/// A config with one cell: a problem as in the list of problems, and further keys after a comma.
inline std::string one_cell(const std::string& problem, const std::string& rest) {
    return R"({"name": "n", "kind": "drift", "problems": [)" + problem +
           R"(], "methods": ["rkmk/rk4"], "time": {"end": 2, "steps": 4})" + rest + "}";
}

}  // namespace kreisel::plan_tests
