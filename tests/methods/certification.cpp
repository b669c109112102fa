// SPDX-License-Identifier: BSD-3-Clause
//
// Every registered method and projection passes the judgements that turn the controls down. Conditions and steps of
// declared schemes are judged in tests/judges/steps.
#include <catch2/catch.hpp>

#include "tests/controls/controls.hpp"

using namespace kreisel;

namespace {

/// Observed orders need complete runs; quad has its own in tests/campaign. What a method remembers, and that it moves
/// alike in every place, is the same code in both precisions.
bool too_slow(Check check) {
    return KREISEL_QUAD && (check == Check::order || check == Check::history || check == Check::equivariance);
}

}  // namespace

TEST_CASE("every registered method passes every check", "[methods]") {
    for (const Judgement& judgement : running_checks()) {
        if (too_slow(judgement.check)) continue;
        for (const Method& entry : methods()) {
            INFO(entry.description.name << ", " << name(judgement.check));
            CHECK(judgement.objection(entry) == "");
        }
    }
}

TEST_CASE("every control is rejected by the checks it names", "[methods][control]") {
    for (const Judgement& judgement : running_checks()) {
        if (too_slow(judgement.check)) continue;
        for (const Control& control : controls()) {
            if (!control.must_be_caught_by(judgement.check)) continue;
            INFO(control.method.description.name << ", " << name(judgement.check));
            CHECK(judgement.objection(control.method) != "");
        }
    }
}

TEST_CASE("every registered projection does what it claims, and no control does", "[methods][control]") {
    for (const ProjectionJudgement& judgement : projection_checks()) {
        for (const ProjectionMethod& entry : projections()) {
            INFO(entry.description.name << ", " << name(judgement.check));
            CHECK(judgement.objection(entry) == "");
        }
        for (const ProjectionControl& control : projection_controls()) {
            if (control.caught_by != judgement.check) continue;
            INFO(control.method.description.name << ", " << name(judgement.check));
            CHECK(judgement.objection(control.method) != "");
        }
    }
}
