// SPDX-License-Identifier: BSD-3-Clause
//
// What single values of a config are. The reader reads by these, and the schema (schema/keys.hpp) tells them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "records/json/node.hpp"

namespace kreisel {

/// A whole number in [least, most].
struct CountKind {
    std::string what;  ///< in messages, "a number of steps"
    long least = 0, most = 0;
};

/// A number greater than 0; and less than `below`, if that is given.
struct PositiveKind {
    std::string what;
    std::optional<double> below = {};
};

/// A text of at most `longest` characters.
struct TextKind {
    std::string what;
    std::size_t longest = 0;
};

/// One of several names.
struct NameKind {
    std::string what;
    std::vector<std::string> names;
};

struct FlagKind {};

/// The value; nothing, after an error, if it is of another kind.
std::optional<long> read(const Node& node, const CountKind& kind);
std::optional<double> read(const Node& node, const PositiveKind& kind);
std::optional<std::string> read(const Node& node, const TextKind& kind);
std::optional<std::string> read(const Node& node, const NameKind& kind);
std::optional<bool> read(const Node& node, const FlagKind& kind);

}  // namespace kreisel
