// SPDX-License-Identifier: BSD-3-Clause
#include "records/provenance.hpp"

#include <CLI/Version.hpp>
#include <boost/version.hpp>
#include <catch2/catch.hpp>
#include <map>
#include <regex>

#include "records/loaded_libraries.hpp"

using namespace kreisel;

TEST_CASE("every library has a version, the one of the headers that were compiled") {
    const auto list = library_versions();
    const std::map<std::string, std::string> versions(list.begin(), list.end());
    CHECK(versions.size() == 7);
    for (const auto& [name, version] : versions) {
        INFO(name << " " << version);
        CHECK(std::regex_match(version, std::regex("[0-9]+(\\.[0-9]+)+")));
    }
    CHECK(versions.at("CLI11") == CLI11_VERSION);
    const std::string boost = std::to_string(BOOST_VERSION / 100000) + "." + std::to_string(BOOST_VERSION / 100 % 1000);
    CHECK(versions.at("Boost").starts_with(boost + "."));
}

TEST_CASE("the loaded numerical libraries have build ids, and the instruction level is known") {
    const auto list = numerical_libraries();
    const std::map<std::string, std::string> ids(list.begin(), list.end());
    for (const char* stem : {"libc.so", "libm.so", "libstdc++.so", "libgsl.so"}) {
        INFO(stem);
        const auto found = ids.lower_bound(stem);
        REQUIRE(found != ids.end());
        REQUIRE(found->first.starts_with(stem));
        CHECK(std::regex_match(found->second, std::regex("[0-9a-f]{16,}")));
    }
    CHECK_FALSE(instruction_level().empty());
#ifdef __x86_64__
    CHECK(instruction_level().starts_with("x86-64"));
#endif
    CHECK(std::regex_match(build_id(), std::regex("[0-9a-f]{16}")));
}
