// SPDX-License-Identifier: BSD-3-Clause
//
// Keys of the bibliography, for the citations of methods, projections and problems.
#pragma once

#include <catch2/catch.hpp>
#include <fstream>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "kreisel_build.hpp"

namespace kreisel {

inline const std::set<std::string>& bibliography() {
    static const std::set<std::string> all = [] {
        std::ifstream file(std::string(build::source_dir) + "/paper/references.bib");
        const std::regex entry(R"(^@\w+\{([^,\s]+),)");
        std::set<std::string> keys;
        std::smatch match;
        for (std::string line; std::getline(file, line);)
            if (std::regex_search(line, match, entry)) keys.insert(match[1]);
        return keys;
    }();
    return all;
}

/// Each key is in the bibliography.
inline void check_cites(const std::string& name, const std::vector<std::string>& cites) {
    REQUIRE(bibliography().size() >= 10);
    for (const std::string& key : cites) {
        INFO(name << " cites " << key);
        CHECK(bibliography().contains(key));
    }
}

}  // namespace kreisel
