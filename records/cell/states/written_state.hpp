// SPDX-License-Identifier: BSD-3-Clause
//
// A state as a line of results tells it, its numbers as written: for what passes them on.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace kreisel {

/// Members as ReportedBody, ReportedReaction and ReportedState have them; the numbers are parts of the line, without
/// the quotes of quad.
struct WrittenBody {
    std::string name;
    std::array<std::string_view, 3> x, v, omega;
    std::array<std::string_view, 9> R;
};

struct WrittenReaction {
    std::string joint;
    std::array<std::string_view, 3> force, torque;
    std::optional<std::string_view> driving_force, driving_torque;
};

struct WrittenState {
    std::string_view t;
    std::vector<WrittenBody> bodies;
    std::vector<std::string_view> multipliers;
    std::vector<std::string> multiplier_names;
    std::vector<WrittenReaction> reactions;
    std::vector<std::string_view> theta, turns;
};

/// What is missing is as in a new state. Throws std::invalid_argument where `json` is not a state.
WrittenState written_state(std::string_view json);

}  // namespace kreisel
