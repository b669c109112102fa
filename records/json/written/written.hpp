// SPDX-License-Identifier: BSD-3-Clause
//
// JSON as this program writes it, without spaces, taken apart without reading its values: for what is passed on as it
// is. The parts point into the text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace kreisel {

struct WrittenMember {
    std::string_view name;  ///< as written, without its quotes
    std::string_view json;
};

/// The members of an object and the elements of a list, in their order. Throws std::invalid_argument where quotes,
/// brackets and commas do not fit together; values are not looked at.
std::vector<WrittenMember> members_of(std::string_view object);
std::vector<std::string_view> elements_of(std::string_view list);

/// The value of the member of that name; empty where there is none.
std::string_view value_of(const std::vector<WrittenMember>& members, std::string_view name);

/// A text without quotes and escapes, a number or flag as written; nothing of null.
std::string text_of(std::string_view json);

}  // namespace kreisel
