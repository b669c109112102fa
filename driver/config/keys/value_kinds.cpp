// SPDX-License-Identifier: BSD-3-Clause
#include "driver/config/keys/value_kinds.hpp"

namespace kreisel {

std::optional<long> read(const Node& node, const CountKind& kind) {
    return node.count(kind.least, kind.most, kind.what);
}

std::optional<double> read(const Node& node, const PositiveKind& kind) {
    const auto value = node.positive(kind.what);
    if (!value || !kind.below || *value < *kind.below) { return value; }
    node.mismatch(kind.what);
    return std::nullopt;
}

std::optional<std::string> read(const Node& node, const TextKind& kind) { return node.text(kind.what, kind.longest); }

std::optional<std::string> read(const Node& node, const NameKind& kind) { return node.name(kind.what, kind.names); }

std::optional<bool> read(const Node& node, const FlagKind& /*kind*/) { return node.flag(); }

}  // namespace kreisel
