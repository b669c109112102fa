// SPDX-License-Identifier: BSD-3-Clause
//
// Extrapolation of variable order that is broken on purpose.
#include <catch2/catch.hpp>

#include "methods/control/stepper.hpp"
#include "tests/judges/steps/scheme_checks.hpp"

using namespace kreisel;

TEST_CASE("steps of variable order that miss their tolerance, or are of another base, are seen",
          "[one_step][control]") {
    const Method& gbs = method("extrapolation/gbs");
    CHECK(one_step_objection(gbs) == "");
    Method broken = gbs;
    broken.description.name = "control/gbs_misses_its_tolerance";
    broken.factory.stepper = [&](System& system, Projection& none, Accuracy accuracy, const OptionValues& options,
                                 const MethodDescription& described) {
        accuracy.tolerance *= 1000;
        return gbs.factory.stepper(system, none, accuracy, options, described);
    };
    CHECK_THAT(one_step_objection(broken), Catch::Contains("of no fixed order which meets the tolerance"));
    broken.description.name = "control/gbs_on_another_base";
    broken.factory.stepper = [&](System& system, Projection& none, const Accuracy& accuracy, const OptionValues&,
                                 const MethodDescription& described) {
        return gbs.factory.stepper(system, none, accuracy, {{"base", "chart"}}, described);
    };
    CHECK_THAT(one_step_objection(broken), Catch::Contains("base group"));
}
