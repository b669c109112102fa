// SPDX-License-Identifier: BSD-3-Clause
//
// The project's source tree as text: files below a root, each also with its comments and strings blanked out.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace architecture {

/// A text file. `path` is relative to the root, with forward slashes. `code` has the same lines as `text`, with
/// comments, string and character literals replaced by blanks (the delimiters stay), so that columns agree.
struct Source {
    std::string path;
    std::string text;
    std::string code;

    std::string folder() const;     ///< "lie" for lie/so3.hpp; empty for a file at the root
    std::string extension() const;  ///< ".hpp"
    bool is_cpp() const;            ///< .cpp or .hpp
    int line_of(std::size_t offset) const;
};

/// C++ text with comments and literals blanked. Knows line and block comments, raw strings, escapes, and that the
/// quote in 1'000 is a digit separator.
std::string blank_comments_and_literals(const std::string& text);

/// All source files below `root` that belong to the project: folders of the architecture, CMake files and scripts.
/// Leaves out build and result folders, and the miniature trees in tests/architecture/bad.
std::vector<Source> load_tree(const std::filesystem::path& root);

std::string read_text(const std::filesystem::path& file);

}  // namespace architecture
