// SPDX-License-Identifier: BSD-3-Clause
//
// One step of the running code against its declared scheme (one_step_check.cpp) or its equations (step_checks.hpp).
// This detects what no observed order can: a missing dexpinv at order 2, the order of stage factors.
#include <catch2/catch.hpp>

#include "tests/controls/broken.hpp"
#include "tests/judges/steps/scheme_checks.hpp"

using namespace kreisel;

TEST_CASE("one step of every registered method is that of its declared scheme or of its equations", "[one_step]") {
    int schemes = 0;
    for (const Method& method : methods()) {
        schemes += method.factory.scheme.has_value();
        INFO(method.description.name);
        CHECK(one_step_objection(method) == "");
        CHECK(order_conditions_objection(method) == "");
    }
    CHECK(schemes >= 10);
}

TEST_CASE("one step tells every option from every other", "[one_step]") {
    // Otherwise the comparison above would not notice an option that is ignored.
    const Method& rk4 = method("rkmk/rk4");
    for (const MatrixGroup& group : {matrix_so3(), matrix_se3()}) {
        const auto all = scheme_variants(rk4);
        REQUIRE(all.size() == 9);
        for (std::size_t i = 0; i < all.size(); ++i)
            for (std::size_t j = 0; j < i; ++j) {
                // q = p - 1 = 3 brackets are q = 2, because B_3 = 0.
                const bool same =
                    all[j].at("dexpinv") == OptionValue("seed") && all[i].at("dexpinv") == OptionValue(2L);
                const Real apart = one_step_difference(rk4, all[i], all[j], group);
                INFO("variants " << i << " and " << j << " on " << group.name << ": " << to_text(apart));
                CHECK((apart > 1000 * one_step_tolerance()) == !same);
            }
    }
}

TEST_CASE("a correct embedded pair, first same as last, is accepted", "[one_step]") {
    const Method correct = broken_pair("a/pair", {});
    CHECK(one_step_objection(correct) == "");
    CHECK(order_conditions_objection(correct) == "");
    CHECK(attempts_objection(correct) == "");
}
