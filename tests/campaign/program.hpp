// SPDX-License-Identifier: BSD-3-Clause
//
// The whole program over the real engines, run inside a test.
#pragma once

#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

#include "driver/cli/cli.hpp"
#include "tests/campaign/acceptance.hpp"

namespace kreisel::acceptance {

/// A folder that is removed when the test ends; no reference enters the user's cache.
class Folder {
  public:
    Folder() {
        std::string pattern = (std::filesystem::temp_directory_path() / "kreisel_program_XXXXXX").string();
        path = ::mkdtemp(pattern.data());
        ::setenv("KREISEL_CACHE", "", 1);
    }
    ~Folder() {
        std::error_code ignored;
        std::filesystem::remove_all(path, ignored);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    /// Writes a file and returns its path.
    std::string file(const std::string& name, const std::string& text) const {
        std::ofstream(path / name) << text;
        return (path / name).string();
    }

    std::filesystem::path path;
};

struct Said {
    int code;
    std::string out, messages;
};

inline Said kreisel_with(std::vector<std::string> words) {
    words.insert(words.begin(), "kreisel");
    std::vector<const char*> arguments;
    for (const std::string& word : words) arguments.push_back(word.c_str());
    std::ostringstream out, messages;
    std::streambuf *const old_out = std::cout.rdbuf(out.rdbuf()), *const old_err = std::cerr.rdbuf(messages.rdbuf());
    const int code =
        kreisel_main(static_cast<int>(arguments.size()), arguments.data(), engine_binary64(), engine_binary128());
    std::cout.rdbuf(old_out), std::cerr.rdbuf(old_err);
    return {code, out.str(), messages.str()};
}

}  // namespace kreisel::acceptance
