// SPDX-License-Identifier: BSD-3-Clause
//
// How bodies, joints and forces are written in a config: one table of types and keys, from which the reader, the JSON
// Schema and `kreisel info` are made.
#pragma once

#include <string>
#include <vector>

#include "problems/description.hpp"

namespace kreisel {

/// The kind of value of a key.
enum class ValueKind {
    name,
    label,
    names,
    number,
    whole,
    positive,
    not_negative,
    vector,
    vectors,
    matrix,
    quaternion,
    inertia,
    frame
};

/// Inclusive bounds of a value of kind `whole`.
inline constexpr long largest_whole = 1'000'000'000;

struct ElementKey {
    std::string name;
    ValueKind kind;
    bool required;
};

/// Two keys of which at most one may be written; exactly one where it is required.
struct Alternative {
    std::string one, other;
    bool required;
};

/// A type of body, joint or force: "type": `name`, and these keys.
struct ElementType {
    std::string name;
    std::string summary;
    std::vector<ElementKey> keys;
    std::vector<Alternative> alternatives = {};
    bool has(const std::string& key) const;
};

/// The entries of one list. The types stand in the order of their enumeration (mechanics/model/data.hpp).
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

/// "type" and the keys of a type.
std::vector<std::string> keys_of(const ElementType& type);

}  // namespace kreisel
