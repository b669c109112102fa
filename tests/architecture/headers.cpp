// SPDX-License-Identifier: BSD-3-Clause
//
// What a header declares is defined in the source of its name, and nowhere else.
#include <regex>
#include <set>

#include "tests/architecture/matching.hpp"
#include "tests/architecture/rooms.hpp"
#include "tests/architecture/rules.hpp"

namespace architecture {

namespace {

/// main(), and the overloads of one function of the second route: a file for each force.
bool is_leaf(const std::string& path) {
    return path == "driver/main.cpp" || lies_in(path, "engine/reference/taylor/forces");
}

bool registers_anything(const Source& source) {
    static const std::regex registration(R"(\nKREISEL_[A-Z_]+\()");
    return std::regex_search(source.code, registration);
}

std::string with_extension(const std::string& path, const std::string& extension) {
    return path.substr(0, path.rfind('.')) + extension;
}

}  // namespace

std::vector<Finding> check_headers(const std::vector<Source>& tree) {
    static const std::regex inclusion(R"re(#include "([^"]+)\.hpp")re");
    std::set<std::string> paths;
    for (const Source& source : tree) { paths.insert(source.path); }
    std::vector<Finding> findings;
    for (const Source& source : tree) {
        const bool is_source = source.extension() == ".cpp" && room_of(source.path) != nullptr;
        if (!is_source || is_leaf(source.path) || registers_anything(source)) { continue; }
        if (paths.contains(with_extension(source.path, ".hpp"))) { continue; }
        std::string shared;
        each_match(source.text, inclusion, [&](const std::smatch& match) {
            if (shared.empty() && paths.contains(match[1].str() + ".cpp")) { shared = match[1].str() + ".hpp"; }
        });
        if (shared.empty()) { continue; }
        findings.push_back(
            {source.path, 1, "header",
             "has no header of its name and registers nothing; it includes " + shared + ", which has a source"});
    }
    return findings;
}

}  // namespace architecture
