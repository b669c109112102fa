// SPDX-License-Identifier: BSD-3-Clause
//
// How bodies, joints and forces are written in a config: one table of types and keys, from which the reader, the JSON
// Schema and `kreisel info` are made.
#pragma once

#include <string>
#include <vector>

#include "mechanics/parts/keys.hpp"
#include "problems/description.hpp"

namespace kreisel {

/// Inclusive bounds of a value of kind `whole`.
inline constexpr long largest_whole = 1'000'000'000;

/// The entries of one list.
struct ElementList {
    std::string what;      ///< "body"
    std::string standard;  ///< default type; empty: an entry must give one
    std::vector<ElementType> types;
};

bool has_elements(ParameterKind kind);
/// Of a parameter of kind bodies, joints or forces.
const ElementList& elements_of(ParameterKind kind);

/// Every key with its meaning, for `kreisel info`.
std::string meaning_of_key(const std::string& key);

/// A value of this kind, in words.
std::string expectation(ValueKind kind);

/// "type" and the keys of a type, that of its shape (records/json/model.hpp) too.
std::vector<std::string> keys_of(const ElementType& type);

}  // namespace kreisel
