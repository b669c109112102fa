// SPDX-License-Identifier: BSD-3-Clause
//
// Crouch-Grossman methods whose source prints 16 decimals or closed forms: what is registered is what the order
// conditions give, rounds to what is printed, and satisfies the conditions as the running code reads it.
#include <catch2/catch.hpp>

#include "methods/tableaus/bound_tableau.hpp"
#include "tests/judges/conditions/registered.hpp"
#include "tests/judges/conditions/solved/crouch_grossman_solution.hpp"

using namespace kreisel;
using namespace kreisel::orders;

namespace {

const Tableau& declared_by(const PublishedCrouchGrossman& published) {
    return scheme_of<CrouchGrossmanScheme>(method(published.method))->tableau;
}

std::vector<Float100> flattened(NumericTableau<Float100> tableau) {
    std::vector<Float100> all;
    each_coefficient(tableau, [&](const Float100& x) { all.push_back(x); });
    return all;
}

/// As the integrator binds it, zeros included.
NumericTableau<Real> as_bound(const Tableau& tableau) {
    NumericTableau<Real> numbers;
    for (const auto& row : tableau.a) {
        numbers.a.emplace_back();
        for (const auto& entry : row) numbers.a.back().push_back(value(entry));
    }
    for (const auto& weight : tableau.b) numbers.b.push_back(value(weight));
    return numbers;
}

NumericTableau<Rational> as_printed(const PublishedCrouchGrossman& published) {
    const auto numbers = [](const PrintedRow& row) {
        std::vector<Rational> values;
        for (const auto& entry : row) values.push_back(orders::exact(Coefficient(entry.c_str())));
        return values;
    };
    NumericTableau<Rational> tableau;
    for (const auto& row : published.a) tableau.a.push_back(numbers(row));
    tableau.b = numbers(published.b);
    return tableau;
}

}  // namespace

TEST_CASE("Crouch-Grossman methods are what their conditions give from the printed tables", "[solved]") {
    for (const PublishedCrouchGrossman& published : {published_cg4a(), published_cg5a(), published_cg43()}) {
        const CrouchGrossmanSolution solution = solve(published);
        CHECK(solution.moved < Float100("1e-16"));
        const auto ours = flattened(in_100_digits(orders::exact(declared_by(published))));
        const auto theirs = flattened(solution.tableau);
        REQUIRE(ours.size() == theirs.size());
        for (std::size_t k = 0; k < ours.size(); ++k) {
            INFO(published.method << ", coefficient " << k << ": " << theirs[k].str(50));
            CHECK(abs(Float100(ours[k] - theirs[k])) < Float100("2e-44"));
        }
    }
}

TEST_CASE("Crouch-Grossman methods satisfy their conditions to their last digits", "[solved]") {
    for (const PublishedCrouchGrossman& published : {published_cg4a(), published_cg5a(), published_cg43()}) {
        const Tableau& tableau = declared_by(published);
        std::size_t count = 0;
        for (int p = 1; p <= published.order; ++p)
            for (const auto& residual : conditions_of_order(orders::exact(tableau), p)) {
                CHECK(abs(residual) < rounding(tableau));
                ++count;
            }
        CHECK(count == (published.order == 4 ? 13 : 38));
    }
}

TEST_CASE("Crouch-Grossman methods satisfy their conditions to round-off in the running precision", "[solved]") {
    const Real bound = KREISEL_QUAD ? from_text("1e-30") : from_text("1e-14");
    for (const PublishedCrouchGrossman& published : {published_cg4a(), published_cg5a(), published_cg43()})
        for (int p = 1; p <= published.order; ++p)
            for (const Real& residual : conditions_of_order(as_bound(declared_by(published)), p))
                CHECK(abs(residual) < bound);
}

TEST_CASE("the printed tables themselves leave residuals that quad would see", "[solved]") {
    for (const PublishedCrouchGrossman& published : {published_cg4a(), published_cg5a()}) {
        Rational largest = 0;
        for (int p = 1; p <= published.order; ++p)
            for (const Rational& r : conditions_of_order(as_printed(published), p))
                largest = std::max<Rational>(largest, abs(r));
        CHECK(largest > orders::exact(Coefficient("0.00000000000000000001")));
        CHECK(largest < orders::exact(Coefficient("0.000000000000001")));
    }
}
