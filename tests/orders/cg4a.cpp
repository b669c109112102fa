// SPDX-License-Identifier: BSD-3-Clause
//
// CG4a, solved again to 44 decimals, is the printed method, and satisfies its conditions as the running code reads it.
#include <catch2/catch.hpp>

#include "methods/tableaus/bound_tableau.hpp"
#include "tests/judges/conditions/crouch_grossman_conditions.hpp"
#include "tests/judges/conditions/published_cg4a.hpp"
#include "tests/judges/conditions/registered.hpp"

using namespace kreisel;
using namespace kreisel::orders;

namespace {

const Tableau& cg4a() { return scheme_of<CrouchGrossmanScheme>(method("crouch_grossman/cg4a"))->tableau; }

std::vector<Rational> flat(NumericTableau<Rational> tableau) {
    std::vector<Rational> all;
    each_coefficient(tableau, [&](const Rational& x) { all.push_back(x); });
    return all;
}

std::vector<Rational> printed() {
    const PrintedTableau table = published_cg4a();
    std::vector<Rational> all;
    for (const auto& row : table.a)
        for (const auto& entry : row) all.push_back(exact(Coefficient(entry.c_str())));
    for (const auto& weight : table.b) all.push_back(exact(Coefficient(weight.c_str())));
    return all;
}

/// As the integrator binds it, zeros included.
NumericTableau<Real> bound() {
    NumericTableau<Real> numbers;
    for (const auto& row : cg4a().a) {
        numbers.a.emplace_back();
        for (const auto& entry : row) numbers.a.back().push_back(value(entry));
    }
    for (const auto& weight : cg4a().b) numbers.b.push_back(value(weight));
    return numbers;
}

}  // namespace

TEST_CASE("CG4a rounds to its printed table", "[cg4a]") {
    const auto ours = flat(exact(cg4a())), theirs = printed();
    REQUIRE(theirs.size() == 15);
    REQUIRE(ours.size() == theirs.size());
    const Rational last_digit = exact(Coefficient("0.0000000000000001"));
    for (std::size_t i = 0; i < ours.size(); ++i) {
        INFO("coefficient " << i << ": " << ours[i].convert_to<double>());
        CHECK(abs(ours[i] - theirs[i]) <= last_digit);
    }
}

TEST_CASE("CG4a satisfies its conditions to its last digits", "[cg4a]") {
    std::size_t count = 0;
    for (int p = 1; p <= 4; ++p) {
        for (const auto& residual : conditions_of_order(exact(cg4a()), p)) CHECK(abs(residual) < rounding(cg4a()));
        count += conditions_of_order(exact(cg4a()), p).size();
    }
    CHECK(count == 13);
}

TEST_CASE("CG4a satisfies its conditions to round-off in the running precision", "[cg4a]") {
    const Real bound_of_residual = KREISEL_QUAD ? from_text("1e-30") : from_text("1e-14");
    for (int p = 1; p <= 4; ++p)
        for (const Real& residual : conditions_of_order(bound(), p)) CHECK(abs(residual) < bound_of_residual);
}

TEST_CASE("the printed table itself leaves residuals that quad would see", "[cg4a]") {
    NumericTableau<Rational> table = exact(cg4a());
    const auto digits = printed();
    std::size_t next = 0;
    each_coefficient(table, [&](Rational& x) { x = digits[next++]; });
    Rational largest = 0;
    for (int p = 1; p <= 4; ++p)
        for (const Rational& r : conditions_of_order(table, p)) largest = std::max<Rational>(largest, abs(r));
    CHECK(largest > exact(Coefficient("0.00000000000000000001")));
    CHECK(largest < exact(Coefficient("0.000000000000001")));
}
