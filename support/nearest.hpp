// SPDX-License-Identifier: BSD-3-Clause
//
// "Did you mean ...?": the valid name nearest to a mistyped one.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace kreisel {

/// Number of insertions, deletions, substitutions and swaps of neighbours that turn `a` into `b`, no part of the text
/// being edited twice (optimal string alignment distance, Damerau 1964).
int edit_distance(std::string_view a, std::string_view b);

/// The name in `names` that `word` most likely stands for, or "" where none is near: the distance (ignoring case) is at
/// most max(1, length/3) edits and no name of another spelling is as near.
std::string nearest_name(std::string_view word, const std::vector<std::string>& names);

}  // namespace kreisel
