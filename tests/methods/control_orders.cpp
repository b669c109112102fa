// SPDX-License-Identifier: BSD-3-Clause
//
// The acceptance problem rejects methods broken on purpose because their observed order is the lower one they
// really have, not by accident.
#include <catch2/catch.hpp>

#include "tests/controls/controls.hpp"
#include "tests/judges/methods/acceptance_curves.hpp"

using namespace kreisel;

#if !KREISEL_QUAD

TEST_CASE("controls show the order they have, not the one they claim", "[methods][control]") {
    for (const Control& control : controls()) {
        if (control.claims_too_much()) continue;
        INFO(control.method.description.name);
        const AcceptanceCurves curves = acceptance_curves(control.method, control.true_order == 1);
        REQUIRE(!curves.empty());
        CHECK(order_rule(curves, control.true_order, true) == "");
        if (control.seen_by_order()) CHECK(order_rule(curves, control.true_order + 1, false) != "");
    }
}

#endif
