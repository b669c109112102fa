// SPDX-License-Identifier: BSD-3-Clause
#include "records/provenance.hpp"

#include <CLI/Version.hpp>
#include <boost/version.hpp>
#include <catch2/catch.hpp>
#include <map>
#include <regex>

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
