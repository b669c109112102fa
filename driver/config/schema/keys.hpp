// SPDX-License-Identifier: BSD-3-Clause
//
// The keys of configs, and what their values are, as the schema tells them.
#pragma once

#include "driver/config/keys/keys.hpp"
#include "driver/config/schema/terms.hpp"

namespace kreisel::schema {

Schema of_kind(const CountKind& kind);
Schema of_kind(const PositiveKind& kind);
Schema of_kind(const TextKind& kind);
Schema of_kind(const NameKind& kind);
Schema of_kind(const FlagKind& kind);

/// An object with these keys and no others; `values` has the value of each by name. Throws std::logic_error if there is
/// one that is not among the keys.
Schema object_of(const ConfigKeys& keys, const Schema& values);

}  // namespace kreisel::schema
