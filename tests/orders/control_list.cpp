// SPDX-License-Identifier: BSD-3-Clause
//
// Every control is rejected by the checks of schemes that it names; tests/methods tests the others.
// On request (tag [list], hidden) prints which check rejects each control, and why, as a table in Markdown.
#include <catch2/catch.hpp>
#include <iostream>

#include "tests/controls/controls.hpp"
#include "tests/judges/steps/scheme_checks.hpp"

using namespace kreisel;

namespace {

const std::vector<Judgement>& scheme_checks() {
    static const std::vector<Judgement> all = {{Check::order_conditions, order_conditions_objection},
                                               {Check::one_step, one_step_objection}};
    return all;
}

}  // namespace

TEST_CASE("controls are rejected by the checks of schemes that they name", "[one_step]") {
    int named = 0;
    for (const Judgement& judgement : scheme_checks())
        for (const Control& control : controls()) {
            if (!control.must_be_caught_by(judgement.check)) continue;
            ++named;
            INFO(control.method.description.name << ", " << name(judgement.check));
            CHECK(judgement.objection(control.method) != "");
        }
    CHECK(named >= 12);
}

TEST_CASE("every control names the checks that must reject it, and there are at least twelve controls", "[one_step]") {
    CHECK(controls().size() >= 12);
    for (const Control& control : controls()) {
        INFO(control.method.description.name);
        CHECK((!control.caught_by.empty() || control.seen_by_order()));
    }
}

#if !KREISEL_QUAD

// Hidden because it tests nothing: it prints what the tests above assert.
TEST_CASE("control -> what catches it", "[.][list]") {
    std::vector<Judgement> all = scheme_checks();
    all.insert(all.end(), running_checks().begin(), running_checks().end());
    std::cout << "| control | caught by | because |\n|---|---|---|\n";
    const auto print = [](const std::string& control, bool required, Check check, const Objection& objection) {
        if (objection.empty()) return;
        std::cout << "| `" << control << "` | " << name(check) << (required ? "" : " (also)") << " | " << objection
                  << " |\n";
    };
    for (const Control& control : controls())
        for (const Judgement& judgement : all)
            print(control.method.description.name, control.must_be_caught_by(judgement.check), judgement.check,
                  judgement.objection(control.method));
    for (const ProjectionControl& control : projection_controls())
        for (const ProjectionJudgement& judgement : projection_checks())
            print(control.method.description.name, control.caught_by == judgement.check, judgement.check,
                  judgement.objection(control.method));
}

#endif
