// SPDX-License-Identifier: BSD-3-Clause
#include "driver/config/schema/terms.hpp"

#include <nlohmann/json.hpp>

#include "records/json/node.hpp"

namespace kreisel::schema {

namespace {

// C1 and the Unicode separators, which the reader refuses too, are beyond the regular expressions of some checkers.
const char* const no_control_characters = "^[^\\u0000-\\u001F\\u007F]*$";

}  // namespace

Schema integer(long least, long most) { return {{"type", "integer"}, {"minimum", least}, {"maximum", most}}; }

Schema number() { return {{"type", "number"}, {"minimum", -largest_number}, {"maximum", largest_number}}; }

Schema positive() { return {{"type", "number"}, {"minimum", least_positive}, {"maximum", largest_number}}; }

Schema not_negative() { return {{"type", "number"}, {"minimum", 0}, {"maximum", largest_number}}; }

Schema list(const Schema& items, std::size_t least) {
    return {{"type", "array"}, {"items", items}, {"minItems", least}};
}

Schema list_of(std::size_t count, const Schema& items) {
    return {{"type", "array"}, {"items", items}, {"minItems", count}, {"maxItems", count}};
}

Schema list_of_three(const Schema& items) { return list_of(3, items); }

Schema set(const Schema& items, std::size_t least) {
    Schema schema = list(items, least);
    schema["uniqueItems"] = true;
    return schema;
}

Schema one_or_set(const Schema& one) { return {{"anyOf", {one, set(one)}}}; }

Schema choice(const std::vector<std::string>& names) { return {{"type", "string"}, {"enum", names}}; }

Schema text(std::size_t longest) {
    return {{"type", "string"}, {"minLength", 1}, {"maxLength", longest}, {"pattern", no_control_characters}};
}

Schema object(const Schema& properties, const std::vector<std::string>& required) {
    Schema schema = {{"type", "object"}, {"properties", properties}, {"additionalProperties", false}};
    if (!required.empty()) { schema["required"] = required; }
    return schema;
}

}  // namespace kreisel::schema
