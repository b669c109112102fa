// SPDX-License-Identifier: BSD-3-Clause
//
// JSON as this program writes it, without spaces, taken apart without reading its values: for what is passed on as it
// is. The parts point into the text.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kreisel {

struct WrittenMember {
    std::string_view name;  ///< as written, without its quotes
    std::string_view json;
};

/// The members of an object and the elements of a list, in their order. Throws std::invalid_argument where quotes,
/// brackets and commas do not fit together; values are not looked at.
std::vector<WrittenMember> members_of(std::string_view object);
/// Those behind the members with which the object begins, up to no comma, if it does; else all.
std::vector<WrittenMember> members_behind(std::string_view begin, std::string_view object);
std::vector<std::string_view> elements_of(std::string_view list);
/// What stands in a list that is no list, and in the lists in it, in their order. Throws as these.
std::vector<std::string_view> scalars_of(std::string_view list);

/// Visits what stands in a list that is no list, and in the lists in it, while its place stands behind the path:
/// ".2.3" of a matrix; or the value itself where it is no list. Throws as these.
void for_each_scalar(std::string_view json, std::string& path, const std::function<void(std::string_view)>& visit);

/// Finds the members of an object by name, at once where they are asked for in their order. Throws as members_of.
class WrittenObject {
  public:
    explicit WrittenObject(std::string_view object) : WrittenObject(members_of(object)) {}
    explicit WrittenObject(std::vector<WrittenMember> members) : members_(std::move(members)) {}
    /// The value of the member of that name; empty where there is none.
    std::string_view value_of(std::string_view name);

  private:
    std::vector<WrittenMember> members_;
    std::size_t next_ = 0;
};

/// A text without quotes and escapes, a number or flag as written; nothing of null.
std::string text_of(std::string_view json);
/// The same as a part of `json`, or where something is escaped, of `unescaped`.
std::string_view text_of(std::string_view json, std::string& unescaped);

}  // namespace kreisel
