// SPDX-License-Identifier: BSD-3-Clause
//
// What figures demand of the rest of a config: one table, which the reader and the JSON Schema follow.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace kreisel {

/// What an experiment has, or is.
enum class Provision { timed, not_timed, samples, repeated, counted, tolerances, constant_steps };

/// Figures of `kinds`, where `x` is given those that are drawn against one of these, need an experiment with that.
struct FigureDemand {
    std::vector<std::string> kinds;
    std::vector<std::string> x;  ///< empty: whatever they are drawn against
    Provision needs = Provision::samples;
    std::string expected;  ///< what a message says is expected

    const char* key() const { return x.empty() ? "kind" : "x"; }
    bool concerns(const std::string& kind, const std::string& drawn_against) const;
};

const std::vector<FigureDemand>& figure_demands();

/// Whether a config, as written, has it.
bool provides(const nlohmann::json& config, Provision what);

/// The kinds of experiments that are timed, or whose cells are repeated for their times.
std::vector<std::string> timed_kinds();
std::vector<std::string> repeated_kinds();

}  // namespace kreisel
