// SPDX-License-Identifier: BSD-3-Clause
//
// JSON whose numbers keep the digits that they are written with: -0, 1e-05 and the 36 digits of a quad number come back
// as the same bytes.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace kreisel {

/// Up to here every whole number is a double.
inline constexpr double largest_exact_whole = 9007199254740992;

struct JsonMember;

struct JsonValue {
    enum class Kind { null, flag, number, text, list, object };

    Kind kind = Kind::null;
    std::string text;                 ///< of a flag or number, as written; of a text, decoded
    std::vector<JsonValue> elements;  ///< of a list
    std::vector<JsonMember> members;  ///< of an object, in their order

    bool is_null() const { return kind == Kind::null; }
    bool is_text() const { return kind == Kind::text; }
    bool is_list() const { return kind == Kind::list; }
    bool is_object() const { return kind == Kind::object; }
    bool is_scalar() const { return !is_null() && !is_list() && !is_object(); }

    /// The member of an object; null where there is none, or where it is null.
    const JsonValue* find(std::string_view name) const;
    /// As find. Throws std::invalid_argument where there is none.
    const JsonValue& at(std::string_view name) const;

    /// The value as that type. Each throws std::invalid_argument where it is none.
    double number() const;  ///< of a number, or of a text that is a decimal number (quad)
    long count() const;
    bool flag() const;
    const std::string& string() const;

    bool operator==(const JsonValue&) const;
};

struct JsonMember {
    std::string name;
    JsonValue value;
    bool operator==(const JsonMember&) const = default;
};

/// Throws std::invalid_argument, with the place, where the text is not one JSON value.
JsonValue parse_exactly(std::string_view text);

/// As JSON without spaces: the bytes that were read, if these were written by this program.
std::string json_value(const JsonValue& value);

/// The same with every number in its shortest form, so that 1 and 1.0 are equal.
std::string canonical_json(const JsonValue& value);

}  // namespace kreisel
