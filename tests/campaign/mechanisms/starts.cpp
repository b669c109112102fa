// SPDX-License-Identifier: BSD-3-Clause
//
// Starts of mechanisms: corrected on demand, completed from the joints, or refused.
#include <catch2/catch.hpp>

#include "tests/campaign/mechanisms/chain.hpp"

namespace kreisel::mechanism_tests {

TEST_CASE("a start that does not meet its joints is projected on demand, and that is said", "[campaign]") {
    const ordered_json apart = changed(
        {{"/joints/1", R"({"type": "spherical", "between": ["crank", "rod"], "points": [[1, 0, 0.01], [1, 0, 0]]})"},
         {"/project_initial", "true"}});
    const Plan plan = plan_with(apart);
    REQUIRE(plan.warnings.size() == 2);  // the other: a trajectory without samples
    CHECK(plan.warnings[0].find("project_initial moved bodies by up to 0.00") != std::string::npos);
    CHECK(plan_with(changed({{"/project_initial", "true"}})).warnings.size() == 1);

    const ordered_json crooked = changed(
        {{"/joints/1", R"({"type": "universal", "between": ["crank", "rod"], "point": [1, 0, 0], "axes": [[0, 1, 0], )"
                       R"([0, 0.1, 1]]})"},
         {"/project_initial", "true"}});
    CHECK(plan_with(crooked).warnings.size() == 2);
}

TEST_CASE("axes that nearly agree are brought together by turning little", "[campaign]") {
    const ordered_json tilted = changed({{"/joints/1",
                                          R"({"type": "prismatic", "between": ["crank", "rod"], "point": [1, 0, 0],
                                             "axes": [[1, 0.001, 0], [1, 0, 0.001]]})"},
                                         {"/project_initial", "true"}});
    const Plan plan = plan_with(tilted);
    REQUIRE(plan.warnings.size() == 2);
    const double turned = std::stod(plan.warnings[0].substr(plan.warnings[0].find(" m and ") + 7));
    CHECK(turned > 0.0003);
    CHECK(turned < 0.002);
}

TEST_CASE("velocities that are not given follow from the joints", "[campaign]") {
    const ordered_json turning = changed({{"/bodies/0/omega", "[0, 3, 0]"}});
    const Outcome outcome = engine_binary64().run(plan_with(turning).cells.at(0).cell(), nullptr, {});
    CHECK(outcome.status == "ok");
    CHECK(refusal(turning) == "");
}

TEST_CASE("velocities that contradict a prescribed coordinate are refused, by what was expected", "[campaign]") {
    const std::string message =
        refusal(changed({{"/joints/0/turn", R"({"polynomial": [0, 2]})"}, {"/bodies/0/omega", "[0, 3, 0]"}}));
    INFO(message);
    CHECK(message.find("velocity level") != std::string::npos);
    CHECK(
        message.find("joint 0 (ground - crank, revolute with driven turn): expected a turn of 2 rad/s, got 3 rad/s") !=
        std::string::npos);
    CHECK(refusal(changed({{"/joints/0/turn", R"({"polynomial": [0, 3]})"}, {"/bodies/0/omega", "[0, 3, 0]"}})) == "");
}

TEST_CASE("a start away from a prescribed coordinate is projected onto it, and that is said", "[campaign]") {
    const Plan plan =
        plan_with(changed({{"/joints/0/turn", R"({"polynomial": [0.3]})"}, {"/project_initial", "true"}}));
    REQUIRE(plan.warnings.size() == 2);
    CHECK(plan.warnings[0].find("project_initial moved bodies by up to") != std::string::npos);
}

}  // namespace kreisel::mechanism_tests
