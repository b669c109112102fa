// SPDX-License-Identifier: BSD-3-Clause
//
// Every registered Munthe-Kaas method satisfies the classical conditions of its declared order, violates one of the
// next order, and its estimate and dense output are of the orders it declares; a change of any single coefficient is
// detected.
#include <catch2/catch.hpp>
#include <set>

#include "methods/conditions/tableau_orders.hpp"
#include "methods/contract/method.hpp"
#include "methods/tableaus/bound_tableau.hpp"
#include "tests/judges/conditions/registered.hpp"
#include "tests/judges/steps/scheme_checks.hpp"

using namespace kreisel;
using namespace kreisel::orders;

namespace {

/// Heun's method with Euler's embedded.
Tableau heun_euler() { return {.a = {{}, {1}}, .b = {{1, 2}, {1, 2}}, .b_hat = {1, 0}, .c = {0, 1}}; }

}  // namespace

TEST_CASE("there are 1, 1, 2, 4, 9, 20, 48, 115, 286, 719 rooted trees with 1 to 10 nodes", "[butcher]") {
    const RootedTrees trees(10);
    const std::vector<std::size_t> expected = {1, 1, 2, 4, 9, 20, 48, 115, 286, 719};
    for (int n = 1; n <= 10; ++n) CHECK(trees.of_order(n).size() == expected[static_cast<std::size_t>(n - 1)]);
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

TEST_CASE("Munthe-Kaas tableaus have their declared order and estimate exactly", "[butcher]") {
    const auto methods = registered<MuntheKaasScheme>();
    REQUIRE(methods.size() >= 20);
    for (const Method* method : methods) {
        INFO(method->description.name);
        CHECK(order_conditions_objection(*method) == "");
        const MethodDescription& declared = method->description;
        const Tableau& tableau = scheme_of<MuntheKaasScheme>(*method)->tableau;
        CHECK(tableau_objection(tableau, declared.order.configuration, declared.estimate) == "");
    }
}

TEST_CASE("a Munthe-Kaas coefficient off by 1e-6 violates a condition", "[butcher]") {
    for (const Method* method : registered<MuntheKaasScheme>()) {
        const MethodDescription& declared = method->description;
        const Tableau& tableau = scheme_of<MuntheKaasScheme>(*method)->tableau;
        each_changed(exact(tableau), [&](const NumericTableau<Rational>& changed, int coefficient) {
            INFO(declared.name << ", coefficient " << coefficient);
            const auto found = tableau_orders(in_100_digits(changed), Float100("1e-40"));
            CHECK(orders_objection(found, declared.order.configuration, declared.estimate) != "");
        });
    }
}

TEST_CASE("an estimate is declared as it is", "[butcher]") {
    CHECK(tableau_objection(heun_euler(), 2, 2) == "");
    CHECK(tableau_objection(heun_euler(), 2, 0) == "has embedded weights and declares no estimate");
    CHECK(tableau_objection(heun_euler(), 2, 3) == "an estimate of order 2 of 3 in h");
    CHECK(tableau_objection(heun_euler(), 3, 2) == "order 2 of 3");
    Tableau alone = heun_euler();
    alone.b_hat.clear();
    CHECK(tableau_objection(alone, 2, 0) == "");
    CHECK(tableau_objection(alone, 2, 2) == "declares an estimate and no embedded weights");
    Tableau euler = heun_euler();  // advanced at the lower order
    std::swap(euler.b, euler.b_hat);
    CHECK(tableau_objection(euler, 1, 2) == "");
    euler.b_hat = {{1, 3}, {2, 3}};
    CHECK(tableau_objection(euler, 1, 2) == "the embedded solution is not better than the one advanced");
    euler.b_hat = euler.b;
    CHECK(tableau_objection(euler, 1, most_order + 1) == "the embedded solution does not tell the error from zero");
}

TEST_CASE("a coefficient of dense output off by 1e-6 lowers its order", "[butcher]") {
    int changes = 0;
    for (const Method* method : registered<MuntheKaasScheme>()) {
        Tableau tableau = scheme_of<MuntheKaasScheme>(*method)->tableau;
        INFO(method->description.name);
        for (auto& row : tableau.dense)
            for (Coefficient& entry : row) {
                const Coefficient declared = entry;
                const Rational changed = exact(declared) + Rational(1, 1000000);
                entry = {static_cast<long>(numerator(changed)), static_cast<long>(denominator(changed))};
                CHECK(dense_order(tableau) < method->description.dense);
                entry = declared, ++changes;
            }
    }
    CHECK(changes >= 30);
}

TEST_CASE("dense output must end where the step does", "[butcher]") {
    Tableau heun = heun_euler();
    CHECK(dense_order(heun) == 0);
    heun.dense = {{1, {-1, 2}}, {0, {1, 2}}};  // theta - theta^2/2, theta^2/2
    CHECK(dense_order(heun) == 2);
    heun.dense = {{1, {-1, 3}}, {0, {1, 3}}};
    CHECK(dense_order(heun) == 0);
}

TEST_CASE("a misprint is named by its row where nodes are given", "[butcher]") {
    Tableau wrong = scheme_of<MuntheKaasScheme>(method("rkmk/dopri5"))->tableau;
    wrong.a[4][1] = {-25380, 2187};
    CHECK(tableau_objection(wrong, 5, 5) == "row 5 misses its node by 0.00914");
    wrong.c.clear();
    CHECK(tableau_objection(wrong, 5, 5).starts_with("order "));
}

TEST_CASE("rationals compare in lowest terms, with terms whose products overflow", "[butcher]") {
    const long big = 4000000000;
    CHECK(Coefficient(6, -4) == Coefficient(-3, 2));
    CHECK(Coefficient(3 * big, 5 * big) == Coefficient(3, 5));
    CHECK_FALSE(Coefficient(big, big + 1) == Coefficient(big + 1, big + 2));
}

TEST_CASE("pairs whose last stage lies where the step ends are known as such", "[butcher]") {
    const std::set<std::string> expected = {"rkmk/bs3", "rkmk/dopri5", "rkmk/tsit5", "rkmk/verner6"};
    for (const Method* method : registered<MuntheKaasScheme>()) {
        const std::string& name = method->description.name;
        INFO(name);
        CHECK(first_same_as_last(scheme_of<MuntheKaasScheme>(*method)->tableau) == expected.contains(name));
    }
}
