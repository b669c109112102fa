// SPDX-License-Identifier: BSD-3-Clause
//
// Entries that name something registered: by its name, or by an object with "name". Internal to the reader.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "driver/config/catalogue.hpp"
#include "records/json/node.hpp"

namespace kreisel {

/// What an entry describes; null, with an error, if it names nothing known.
template <class Description>
const Description* described(const Node& entry, const std::string& what, const std::vector<Description>& known) {
    const auto names = names_of(known);
    if (!entry.is_object()) {
        if (!entry.is_string()) {
            entry.mismatch(fmt::format("a {}: a name, or an object with \"name\" and options", what));
            return nullptr;
        }
        const auto name = entry.name("a " + what, names);
        return name ? find_named(known, *name) : nullptr;
    }
    const auto node = entry.require("name", "a " + what);
    const auto name = node ? node->name("a " + what, names) : std::nullopt;
    return name ? find_named(known, *name) : nullptr;
}

/// The descriptions that an entry of the list names: one, or several by "*" and "family/*".
template <class Description>
std::vector<const Description*> described_by(const Node& entry, const std::string& what,
                                             const std::vector<Description>& known) {
    std::vector<const Description*> all;
    const std::string text = entry.is_string() ? entry.json().get<std::string>() : "";
    const auto wildcards = wildcards_of(known);
    if (std::find(wildcards.begin(), wildcards.end(), text) == wildcards.end()) {
        if (const Description* one = described(entry, what, known)) { all.push_back(one); }
        return all;
    }
    for (const Description& one : known) {
        if (one.name.starts_with(text.substr(0, text.size() - 1))) { all.push_back(&one); }
    }
    return all;
}

}  // namespace kreisel
