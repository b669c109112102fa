// SPDX-License-Identifier: BSD-3-Clause
//
// Every registered Munthe-Kaas method satisfies the classical conditions of its declared order exactly, violates one of
// the next order, and a change of any single coefficient is detected.
#include <catch2/catch.hpp>

#include "methods/contract/method.hpp"
#include "tests/judges/conditions/registered.hpp"
#include "tests/judges/conditions/rooted_trees.hpp"
#include "tests/judges/steps/scheme_checks.hpp"

using namespace kreisel;
using namespace kreisel::orders;

TEST_CASE("there are 1, 1, 2, 4, 9, 20 rooted trees with 1 to 6 nodes", "[butcher]") {
    const RootedTrees trees(6);
    const std::vector<std::size_t> expected = {1, 1, 2, 4, 9, 20};
    for (int n = 1; n <= 6; ++n) CHECK(trees.of_order(n).size() == expected[static_cast<std::size_t>(n - 1)]);
}

TEST_CASE("densities run from n (a bush) to n! (a tall tree)", "[butcher]") {
    const RootedTrees trees(6);
    long factorial = 1;
    for (int n = 1; n <= 6; ++n) {
        factorial *= n;
        long least = factorial, greatest = 0;
        for (const std::size_t tree : trees.of_order(n)) {
            least = std::min(least, trees.density(tree));
            greatest = std::max(greatest, trees.density(tree));
        }
        CHECK(least == n);
        CHECK(greatest == factorial);
    }
}

TEST_CASE("Munthe-Kaas tableaus have their declared order exactly", "[butcher]") {
    const auto methods = registered<MuntheKaasScheme>();
    REQUIRE(methods.size() >= 6);
    for (const Method* method : methods) {
        INFO(method->description.name);
        CHECK(order_conditions_objection(*method) == "");
    }
}

TEST_CASE("a Munthe-Kaas coefficient off by 1e-6 violates a condition of the declared order", "[butcher]") {
    for (const Method* method : registered<MuntheKaasScheme>()) {
        const Tableau& tableau = scheme_of<MuntheKaasScheme>(*method)->tableau;
        each_changed(exact(tableau), [&](const NumericTableau<Rational>& changed, int coefficient) {
            INFO(method->description.name << ", coefficient " << coefficient);
            CHECK(butcher_order(changed, rounding(tableau)) < method->description.order.configuration);
        });
    }
}
