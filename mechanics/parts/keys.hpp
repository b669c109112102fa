// SPDX-License-Identifier: BSD-3-Clause
//
// How a body, a joint or a force is written down: a type and its keys. The reader of configs, the JSON Schema, the
// writer of manifests and `kreisel info` are made from these.
#pragma once

#include <string>
#include <vector>

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
    numbers,
    vector,
    not_negatives,
    vectors,
    matrix,
    quaternion,
    inertia,
    frame,
    motion,
    teeth
};

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
    bool has(const std::string& key) const {
        for (const ElementKey& one : keys)
            if (one.name == key) return true;
        return false;
    }
};

}  // namespace kreisel
