// SPDX-License-Identifier: BSD-3-Clause
//
// kreisel new: what it writes, and what it refuses. tests/scaffolds compiles and runs what it writes.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "driver/cli/scaffold/scaffold.hpp"
#include "support/errors.hpp"
#include "tests/driver/command_line.hpp"
#include "tests/driver/config/schema_checker.hpp"

using namespace kreisel;

namespace {

ProgramResult begin(const std::string& kind, const std::string& name, const std::filesystem::path& folder) {
    return run_program({"new", kind, name, "-o", folder.string()});
}

std::size_t longest_line(const std::string& text) {
    std::size_t longest = 0;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = text.find('\n', at);
        longest = std::max(longest, end - at);
        at = end + 1;
    }
    return longest;
}

}  // namespace

TEST_CASE("a method of each family with a scaffold is one file that registers it") {
    const ScratchFolder scratch;
    CHECK(scaffold_families() == std::vector<std::string>{"commutator_free", "crouch_grossman", "rkmk"});
    for (const std::string& family : scaffold_families()) {
        for (const std::string scheme : {"my3", "a_name_of_20_letters"}) {
            const ProgramResult result = begin("method", family + "/" + scheme, scratch / family);
            INFO(family << "/" << scheme << ": " << result.messages);
            CHECK(result.code == 0);
            const auto file = scratch / (family + "/" + scheme + ".cpp");
            CHECK(result.out == file.string() + "\n");
            const std::string text = contents(file);
            CHECK(text.find("{.name = \"" + family + "/" + scheme + "\",") != std::string::npos);
            CHECK(text.find('@') == std::string::npos);
            CHECK(longest_line(text) <= 120);
        }
    }
}

TEST_CASE("a problem and an experiment are written, the experiment is one of the schema") {
    const ScratchFolder scratch;
    CHECK(begin("problem", "my_rod", scratch / "").code == 0);
    CHECK(contents(scratch / "my_rod.cpp").find(".name = \"my_rod\"") != std::string::npos);
    CHECK(begin("experiment", "my_orders", scratch / "").code == 0);
    const auto config = nlohmann::json::parse(contents(scratch / "my_orders.json"));
    CHECK(config.at("name") == "my_orders");
    CHECK(SchemaChecker(Catalogue(engine_binary64())).accepts(config));
}

TEST_CASE("nothing is overwritten") {
    const ScratchFolder scratch;
    const std::string file = scratch.file("my_rod.cpp", "mine\n");
    const ProgramResult result = begin("problem", "my_rod", scratch / "");
    CHECK(result.code == static_cast<int>(Exit::io));
    CHECK(result.messages.find("nothing is overwritten") != std::string::npos);
    CHECK(contents(file) == "mine\n");
}

TEST_CASE("names that cannot be, and those that there are, are refused with the nearest valid one") {
    const ScratchFolder scratch;
    struct Refused {
        std::string kind, name, phrase;
    };
    for (const Refused& one : std::vector<Refused>{{"method", "my3", "FAMILY/SCHEME"},
                                                   {"method", "rkm/my3", "did you mean \"rkmk\"?"},
                                                   {"method", "splitting/my3", "Adding a method"},
                                                   {"method", "rkmk/rk4", "which there is"},
                                                   {"method", "rkmk/My3", "a-z, 0-9 and _"},
                                                   {"method", "rkmk/a/b", "a-z, 0-9 and _"},
                                                   {"method", "rkmk/", "a-z, 0-9 and _"},
                                                   {"method", "rkmk/3rd", "beginning with a letter"},
                                                   {"method", "rkmk/a_name_of_21_letters_", "1 to 20"},
                                                   {"problem", "heavy_top", "which there is"},
                                                   {"problem", "../rod", "a-z, 0-9 and _"},
                                                   {"experiment", "orders_heavy_top", "which there is: "},
                                                   {"experiment", "a b", "a-z, 0-9 and _"},
                                                   {"metod", "rkmk/my3", "method"}}) {
        const ProgramResult result = begin(one.kind, one.name, scratch / "out");
        INFO(one.kind << " " << one.name << ": " << result.messages);
        CHECK(result.code == static_cast<int>(Exit::usage));
        CHECK(result.messages.find(one.phrase) != std::string::npos);
        CHECK_FALSE(std::filesystem::exists(scratch / "out"));
    }
}
