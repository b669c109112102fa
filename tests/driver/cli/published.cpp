// SPDX-License-Identifier: BSD-3-Clause
//
// Digits that agree, and the list of published numbers.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>

#include "driver/cli/published/agreement.hpp"
#include "support/errors.hpp"
#include "tests/driver/command_line.hpp"

using namespace kreisel;

namespace {

const std::string head_of_list = "config,cells,column,printed,factor,digits,source,remark\n";

// Runs `published` with one line, over a config of the fake engine's top.
ProgramResult published_with(const std::string& line) {
    const ScratchFolder folder;
    std::filesystem::create_directories(folder / "published");
    folder.file("published/published.csv", head_of_list + line + "\n");
    folder.file("top.json", R"({"name": "top", "kind": "trajectory", "problems": ["heavy_top"], "methods": ["rkmk/rk4"],
        "formulations": ["SO3xR3", "SE3"], "time": {"end": 1.0, "steps": 8}})");
    ::setenv("KREISEL_EXPERIMENTS", (folder / "").c_str(), 1);
    const auto result = run_program({"published", "-o", (folder / "out").string()});
    ::unsetenv("KREISEL_EXPERIMENTS");
    return result;
}

}  // namespace

TEST_CASE("digits of printed numbers, and those that agree") {
    CHECK(significant_digits("-14.07838969279822") == 16);
    CHECK(significant_digits("0.0012") == 2);
    CHECK(significant_digits("0.000") == 3);
    CHECK(agreeing_digits("1.2346", 1.23456L) == 5);
    CHECK(agreeing_digits("1.2346", 1.2348L) == 3);
    CHECK(agreeing_digits("1.2346", -1.2346L) == 0);
    CHECK(agreeing_digits("0.000", 0.0004L) == 3);
    CHECK(agreeing_digits("0.000", 0.02L) == 1);
}

TEST_CASE("published prints what agrees, and fails where less does than the list says") {
    // x_2 = sin(2)/15 in the fake engine, printed in units of 1/15 m.
    const auto exact = published_with("top,,final.top.x.2 [m],0.90930,0.06666666666666667,5,someone 1999,in parts");
    INFO(exact.out << exact.messages);
    CHECK(exact.code == 0);
    CHECK_THAT(exact.out, Catch::Contains("5 of 5") && Catch::Contains("someone 1999"));
    const auto wrong = published_with("top,,final.top.x.2 [m],0.84147,0.06666666666666667,5,someone 1999,in parts");
    CHECK(wrong.code == 1);
    CHECK_THAT(wrong.messages, Catch::Contains("expected 5 digits of 0.84147, got 1"));
    const auto mode = published_with("top,,eigenvalue.2.imaginary,-1.0000,1,5,someone 1999,");
    CHECK(mode.code == 0);
}

TEST_CASE("a damaged list, or a quantity that is not there, is an error") {
    CHECK_THAT(published_with("top,,final.top.x.2 [m],1e-3,1,1,someone,").messages,
               Catch::Contains("published.csv:2: expected a decimal number without exponent, got \"1e-3\""));
    CHECK_THAT(published_with("top,,final.top.x.2 [m],1.0,1,3,someone,").messages,
               Catch::Contains("expected from 1 to 2 digits, got 3"));
    CHECK_THAT(published_with("top,,final.top.x.2 [m],1.0,1").messages, Catch::Contains("expected 8 fields, got 5"));
    const auto absent = published_with("top,,final.bottom.x.1 [m],1.0,1,1,someone,");
    CHECK(absent.code == 2);
    CHECK_THAT(absent.messages, Catch::Contains("with a column final.bottom.x.1 [m]"));
}
