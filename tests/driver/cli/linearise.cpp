// SPDX-License-Identifier: BSD-3-Clause
//
// What `kreisel linearise` prints and writes; the eigenvalues themselves: tests/engine/linearised.cpp.
#include <catch2/catch.hpp>

#include "tests/driver/command_line.hpp"

using namespace kreisel;

namespace {

std::string config_of_top(const char* mass, const char* formulations) {
    return std::string(R"({"name": "some", "kind": "trajectory", "methods": ["rkmk/rk4"],
        "problems": [{"name": "heavy_top", "parameters": {"mass": )") +
           mass + R"(}}], "formulations": )" + formulations + R"(, "time": {"end": 1.0, "steps": 8}})";
}

}  // namespace

TEST_CASE("linearise prints the steady motion and its eigenvalues, and writes all digits") {
    const ScratchFolder scratch;
    const auto result = run_program({"linearise", scratch.file("some.json", config_of_top("1", R"(["SO3xR3", "SE3"])")),
                                     "-o", (scratch / "out").string()});
    INFO(result.messages << result.out);
    REQUIRE(result.code == 0);
    CHECK_THAT(result.out,
               Catch::StartsWith("heavy_top on SO3xR3: steady motion: spin of top about (0, 0, 1), 2 rad/s\n"
                                 "  missed by 1.0e-30 1/s; 6 dimensions on the constraints; eigenvalues to "
                                 "1.0e-25 1/s\n"));
    const std::string table = contents(scratch / "out" / "linearisation.csv");
    CHECK_THAT(table, Catch::Contains("heavy_top,SE3,across,1e-31,-1,2,"));
    CHECK_THAT(table, Catch::Contains("heavy_top,SE3,symmetry,0,0,2,"));
    CHECK_THAT(contents(scratch / "out" / "linearisation.md"), !Catch::Contains("e-31"));
}

TEST_CASE("a start that moves unsteadily is an error, a formulation that does not apply is none") {
    const ScratchFolder scratch;
    const auto refused = run_program({"linearise", scratch.file("some.json", config_of_top("2000", R"(["SO3xR3"])"))});
    CHECK(refused.code == 2);
    CHECK_THAT(refused.messages,
               Catch::Contains("heavy_top on SO3xR3: it is neither an equilibrium nor a steady motion\n"));
    std::string links = config_of_top("1", R"(["SO3", "SE3"])");
    links.replace(links.find("heavy_top"), 9, "double_pendulum");
    links.replace(links.find("\"mass\": 1"), 9, "");
    const auto skipped = run_program({"linearise", scratch.file("links.json", links)});
    CHECK(skipped.code == 0);
    CHECK_THAT(skipped.out, Catch::StartsWith("double_pendulum on SO3: skipped: no body rotates"));
}

TEST_CASE("linearise takes the state that time names") {
    const ScratchFolder scratch;
    std::string config = config_of_top("1", R"(["SO3xR3"])");
    config.replace(config.find("\"end\": 1.0"), 10,
                   R"("end": 4, "begin": {"t": 3, "bodies": [{"name": "top", "x": [0, 0, 0], "v": [0, 0, 0],
                       "R": [[1, 0, 0], [0, 1, 0], [0, 0, 1]], "omega": [0, 0, 3]}]})");
    const auto result = run_program({"linearise", scratch.file("some.json", config)});
    INFO(result.messages);
    CHECK(result.code == 0);
    CHECK_THAT(
        result.out,
        Catch::StartsWith("heavy_top on SO3xR3 at t = 3 s: steady motion: spin of top about (0, 0, 1), 3 rad/s\n"));
}
