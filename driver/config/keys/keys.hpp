// SPDX-License-Identifier: BSD-3-Clause
//
// The keys of a config, of its `time` and its `output`: which there are, which are required, what they mean and what
// their values are. Reader and schema take all of it from here.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "driver/config/keys/value_kinds.hpp"

namespace kreisel {

struct ConfigKey {
    std::string name;
    std::string meaning;       ///< with unit and default
    std::string missing = "";  ///< what is expected where it is not there; empty: it need not be there
};
using ConfigKeys = std::vector<ConfigKey>;

const ConfigKeys& config_keys();
const ConfigKeys& time_keys();
/// Of `begin` in `time`: a state, the bodies of one, or the file that has it.
const ConfigKeys& begin_keys();
const ConfigKeys& begin_body_keys();
const ConfigKeys& begin_file_keys();
const ConfigKeys& output_keys();
/// {"from": N, "levels": k, "factor": f}: N f^j of numbers of steps, N / f^j of tolerances.
const ConfigKeys& step_series_keys();
const ConfigKeys& tolerance_series_keys();

const TextKind& description_kind();
const NameKind& kind_of_experiment();
const NameKind& precision_kind();
const PositiveKind& end_kind();
const PositiveKind& step_kind();
const CountKind& step_count_kind();
const PositiveKind& tolerance_kind();
const NameKind& controller_kind();
const CountKind& level_count_kind();
const CountKind& level_factor_kind();
const CountKind& sample_count_kind();

/// The value of a key; nothing if it is not there, which is an error if it is required.
std::optional<Node> find_key(const Node& object, const ConfigKeys& keys, const std::string& name);

/// The same, read; nothing also if it is of another kind.
template <class Kind>
auto read_key(const Node& object, const ConfigKeys& keys, const std::string& name, const Kind& kind)
    -> decltype(read(object, kind)) {
    const auto node = find_key(object, keys, name);
    if (!node) { return std::nullopt; }
    return read(*node, kind);
}

/// The same with a default.
template <class Kind, class Value>
std::optional<Value> read_key(const Node& object, const ConfigKeys& keys, const std::string& name, const Kind& kind,
                              const Value& standard) {
    const auto node = find_key(object, keys, name);
    return node ? read(*node, kind) : std::optional<Value>(standard);
}

}  // namespace kreisel
