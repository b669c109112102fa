// SPDX-License-Identifier: BSD-3-Clause
#include "methods/splitting/splitting.hpp"

#include <catch2/catch.hpp>

#include "tests/judges/steps/scheme_checks.hpp"

using namespace kreisel;

TEST_CASE("splitting with a coefficient off by 1e-6 is rejected", "[one_step][splitting][control]") {
    Method off = method("splitting/strang");
    CHECK(one_step_objection(off) == "");
    off.factory = splitting({.kicks = {{500001, 1000000}}, .drifts = {1}});
    CHECK(one_step_objection(off) != "");
    off.factory = splitting({.kicks = {{1, 2}}, .drifts = {{1000001, 1000000}}});
    CHECK(one_step_objection(off) != "");
}
