// SPDX-License-Identifier: BSD-3-Clause
//
// The generated Crouch-Grossman conditions are the literature's, and every registered Crouch-Grossman method satisfies
// those of its declared order, violates one of the next, and a change of any coefficient or of the order of factors is
// detected.
#include <Eigen/LU>
#include <catch2/catch.hpp>
#include <random>

#include "tests/judges/conditions/crouch_grossman_system.hpp"
#include "tests/judges/conditions/registered.hpp"
#include "tests/judges/steps/scheme_checks.hpp"

using namespace kreisel;
using namespace kreisel::orders;

namespace {

using Exact = NumericTableau<Rational>;

const Tableau& declared(const std::string& name) { return scheme_of<CrouchGrossmanScheme>(method(name))->tableau; }

/// Rationals without structure, the same on every run.
Exact random_tableau(std::size_t stages) {
    std::mt19937 generator(1);
    Exact tableau;
    for (std::size_t i = 0; i < stages; ++i) tableau.a.emplace_back(i);
    tableau.b.resize(stages);
    each_coefficient(tableau, [&](Rational& x) { x = Rational(static_cast<int>(generator() % 199) - 99, 100); });
    return tableau;
}

std::vector<Rational> nodes(const Exact& tableau) {
    std::vector<Rational> c;
    for (const auto& row : tableau.a) {
        c.emplace_back(0);
        for (const auto& entry : row) c.back() += entry;
    }
    return c;
}

/// The conditions to order 3 as the literature writes them: sum b, sum b c, sum b c^2, sum b_i a_ij c_j,
/// sum b_i^2 c_i + 2 sum_{i<j} b_i c_i b_j, minus 1, 1/2, 1/3, 1/6, 1/3.
std::vector<Rational> written_conditions(const Exact& tableau) {
    const auto c = nodes(tableau);
    const auto& b = tableau.b;
    std::vector<Rational> sums = {Rational(-1), Rational(-1, 2), Rational(-1, 3), Rational(-1, 6), Rational(-1, 3)};
    for (std::size_t i = 0; i < b.size(); ++i) {
        sums[0] += b[i];
        sums[1] += b[i] * c[i];
        sums[2] += b[i] * c[i] * c[i];
        for (std::size_t j = 0; j < i; ++j) sums[3] += b[i] * tableau.a[i][j] * c[j];
        sums[4] += b[i] * b[i] * c[i];
        for (std::size_t j = i + 1; j < b.size(); ++j) sums[4] += 2 * b[i] * c[i] * b[j];
    }
    return sums;
}

}  // namespace

TEST_CASE("forests and independent conditions are as many as they must be", "[crouch_grossman]") {
    const OrderedForests forests(5);
    const std::vector<std::size_t> all = {1, 2, 5, 14, 42}, independent = {1, 1, 3, 8, 25};
    for (int n = 1; n <= 5; ++n) {
        CHECK(forests.of_order(n).size() == all[static_cast<std::size_t>(n - 1)]);
        CHECK(forests.lyndon(n).size() == independent[static_cast<std::size_t>(n - 1)]);
    }
}

TEST_CASE("the conditions on Lyndon words are independent", "[crouch_grossman]") {
    const std::size_t stages = 9;
    NumericTableau<Float100> tableau;
    const Exact random = random_tableau(stages);
    for (const auto& row : random.a) tableau.a.emplace_back(row.begin(), row.end());
    tableau.b = std::vector<Float100>(random.b.begin(), random.b.end());
    const Matrix100 jacobian = conditions_jacobian(unknowns(tableau), stages, 5);
    REQUIRE(jacobian.rows() == 1 + 1 + 3 + 8 + 25);
    Eigen::FullPivLU<Matrix100> lu(jacobian);
    lu.setThreshold(Float100("1e-30"));  // the differences are accurate to about 50 digits
    CHECK(lu.rank() == jacobian.rows());
}

TEST_CASE("method and flow are characters of the shuffle product", "[crouch_grossman]") {
    // So that the values on Lyndon words determine all others. Two trees s, t: y(s) y(t) = y(st) + y(ts).
    const OrderedForests forests(5);
    for (const auto& y : {exact_series<Rational>(forests), crouch_grossman_series(forests, random_tableau(4))}) {
        int pairs = 0;
        for (std::size_t w = 0; w < forests.size(); ++w) {
            const auto& word = forests.word(w);
            if (word.size() != 2) continue;
            ++pairs;
            const auto single = [&](OrderedForests::Tree tree) { return y[forests.find({tree})]; };
            CHECK(single(word[0]) * single(word[1]) == y[w] + y[forests.find({word[1], word[0]})]);
        }
        CHECK(pairs == 1 + 2 + 5 + 14);
    }
}

TEST_CASE("the generated conditions to order 3 are those of the literature", "[crouch_grossman]") {
    const Exact tableau = random_tableau(4);
    const auto written = written_conditions(tableau);
    CHECK(conditions_of_order(tableau, 1)[0] == written[0]);
    CHECK(conditions_of_order(tableau, 2)[0] == written[1]);
    // Of order 3, as residuals on [s[s]], [ss] and on a Lyndon word of two trees: 1/6, 1/3 / 2!, and one of two.
    const OrderedForests forests(3);
    const auto method = crouch_grossman_series(forests, tableau), flow = exact_series<Rational>(forests);
    const auto residual = [&](const OrderedForests::Word& word) {
        return Rational(method[forests.find(word)] - flow[forests.find(word)]);
    };
    const OrderedForests::Tree dot = 0, branch = forests.find({dot}), bush = forests.find({dot, dot}),
                               tall = forests.find({branch});
    CHECK(residual({bush}) * 2 == written[2]);
    CHECK(residual({tall}) == written[3]);
    CHECK(residual({branch, dot}) * 2 == written[4]);
}

TEST_CASE("Crouch-Grossman tableaus have their declared order exactly", "[crouch_grossman]") {
    const auto methods = registered<CrouchGrossmanScheme>();
    REQUIRE(methods.size() >= 4);
    for (const Method* method : methods) {
        INFO(method->description.name);
        const Tableau& tableau = scheme_of<CrouchGrossmanScheme>(*method)->tableau;
        const int p = method->description.order.configuration;
        CHECK(order_conditions_objection(*method) == "");
        const OrderedForests forests(p);  // and not only on Lyndon words
        const auto series = crouch_grossman_series(forests, exact(tableau)), flow = exact_series<Rational>(forests);
        for (std::size_t w = 0; w < forests.size(); ++w) CHECK(abs(series[w] - flow[w]) <= rounding(tableau));
    }
}

TEST_CASE("a Crouch-Grossman coefficient off by 1e-6 violates a condition of the declared order", "[crouch_grossman]") {
    for (const Method* method : registered<CrouchGrossmanScheme>()) {
        const Tableau& tableau = scheme_of<CrouchGrossmanScheme>(*method)->tableau;
        each_changed(exact(tableau), [&](const Exact& changed, int coefficient) {
            INFO(method->description.name << ", coefficient " << coefficient);
            const auto [step, embedded] = crouch_grossman_orders(changed, rounding(tableau));
            const bool lowered = step < method->description.order.configuration ||
                                 std::min(step, embedded) + 1 < method->description.estimate;
            CHECK(lowered);
        });
    }
}

TEST_CASE("the order of the factors matters, and where", "[crouch_grossman]") {
    const auto order = [](const std::string& name, Factors stage_factors, Factors final_factors) {
        return crouch_grossman_order(exact(declared(name)), rounding(declared(name)), stage_factors, final_factors);
    };
    const auto ascending = Factors::ascending, descending = Factors::descending;
    CHECK(order("crouch_grossman/cg3a", ascending, descending) == 2);
    CHECK(order("crouch_grossman/cg3b", ascending, descending) == 2);
    CHECK(order("crouch_grossman/cg4a", ascending, descending) == 2);
    // Two different branches at one node take four nodes: orders up to 3 do not involve the stage products.
    CHECK(order("crouch_grossman/cg3a", descending, ascending) == 3);
    CHECK(order("crouch_grossman/cg3b", descending, ascending) == 3);
    CHECK(order("crouch_grossman/cg4a", descending, ascending) == 3);
}

TEST_CASE("CG4a with the entries of its rows reversed has order 2", "[crouch_grossman]") {
    const Tableau& tableau = declared("crouch_grossman/cg4a");
    Exact reversed = exact(tableau);
    for (auto& row : reversed.a) std::reverse(row.begin(), row.end());
    CHECK(crouch_grossman_order(reversed, rounding(tableau)) == 2);
}
