// SPDX-License-Identifier: BSD-3-Clause
//
// The terms that the JSON Schema of configs is written in.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace kreisel::schema {

using Schema = nlohmann::ordered_json;

Schema integer(long least, long most);
Schema number();
Schema positive();
Schema not_negative();
/// Of at least `least` items.
Schema list(const Schema& items, std::size_t least = 1);
Schema list_of(std::size_t count, const Schema& items);
Schema list_of_three(const Schema& items);
/// A list of different items, at least `least`.
Schema set(const Schema& items, std::size_t least = 1);
Schema one_or_set(const Schema& one);
Schema choice(const std::vector<std::string>& names);
/// Of 1 to `longest` characters, without control characters.
Schema text(std::size_t longest);
/// With these properties and no others.
Schema object(const Schema& properties, const std::vector<std::string>& required);

}  // namespace kreisel::schema
