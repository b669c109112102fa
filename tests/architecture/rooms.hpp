// SPDX-License-Identifier: BSD-3-Clause
//
// The rooms of the house: a folder (or a single header) each, and what its files may include.
#pragma once

#include <string>
#include <vector>

namespace architecture {

using Names = std::vector<std::string>;

/// `reach`: rooms, folders with all that is below them, or single headers, beside the room itself. `libraries`:
/// prefixes of the path between <>, beside the standard library. `talks`: knows files, terminal and operating system.
struct Room {
    std::string name;
    Names reach, libraries;
    bool talks = false;
};

/// The room that a file belongs to: the one with the longest name that begins its path. Null outside the house.
const Room* room_of(const std::string& path);

/// How many sources may lie in a folder: 20, but 40 in those to which each new problem, method, kind or
/// table adds one.
std::size_t capacity_of(const std::string& folder);

/// Folders whose files see everything.
const Names& outbuildings();

/// `path` is `place` or lies below it.
bool lies_in(const std::string& path, const std::string& place);

}  // namespace architecture
