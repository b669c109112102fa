// SPDX-License-Identifier: BSD-3-Clause
//
// Every method and projection cites keys that the bibliography has.
#include <catch2/catch.hpp>
#include <fstream>
#include <regex>
#include <set>

#include "kreisel_build.hpp"
#include "methods/method.hpp"
#include "methods/projection.hpp"

using namespace kreisel;

namespace {

std::set<std::string> bibliography() {
    std::ifstream file(std::string(build::source_dir) + "/paper/references.bib");
    const std::regex entry(R"(^@\w+\{([^,\s]+),)");
    std::set<std::string> keys;
    std::smatch match;
    for (std::string line; std::getline(file, line);)
        if (std::regex_search(line, match, entry)) keys.insert(match[1]);
    return keys;
}

}  // namespace

TEST_CASE("what methods and projections cite is in the bibliography", "[methods]") {
    const auto known = bibliography();
    REQUIRE(known.size() >= 10);
    CHECK_FALSE(known.contains("nobody1900"));
    const auto check = [&](const auto& description) {
        INFO(description.name);
        for (const std::string& key : description.cites) {
            INFO(key);
            CHECK(known.contains(key));
        }
    };
    for (const Method& entry : methods()) check(entry.description);
    for (const ProjectionMethod& entry : projections()) check(entry.description);
}
