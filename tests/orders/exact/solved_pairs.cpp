// SPDX-License-Identifier: BSD-3-Clause
//
// Pairs whose sources print too few digits: what is registered is what the order conditions give, and rounds to what is
// printed.
#include <catch2/catch.hpp>

#include "tests/judges/conditions/pair_solution.hpp"
#include "tests/judges/conditions/registered.hpp"

using namespace kreisel;
using namespace kreisel::orders;

namespace {

std::vector<Float100> all_entries(NumericTableau<Float100> tableau) {
    std::vector<Float100> all;
    for (std::size_t i = 0; i < tableau.a.size(); ++i) tableau.a[i].resize(i);  // zeros at the end of a row
    each_coefficient(tableau, [&](const Float100& x) { all.push_back(x); });
    return all;
}

void check_solved(const PublishedPair& pair, std::size_t held) {
    const PairSolution solution = solve(pair);
    const auto declared = exact(scheme_of<MuntheKaasScheme>(method(pair.method))->tableau);
    const auto ours = all_entries(in_100_digits(declared)), theirs = all_entries(solution.tableau);
    CHECK(solution.held.size() == held);
    CHECK(solution.moved < pair.printed_to);
    REQUIRE(ours.size() == theirs.size());
    for (std::size_t k = 0; k < ours.size(); ++k) {
        INFO(pair.method << ", coefficient " << k << ": " << theirs[k].str(50));
        CHECK(abs(Float100(ours[k] - theirs[k])) < Float100("1e-44"));
    }
}

}  // namespace

TEST_CASE("the conditions of the orders 5 and 4 give the pair of Tsitouras from five numbers", "[solved]") {
    check_solved(published_tsit5(), 5);
}

TEST_CASE("the conditions of the orders 8 and 5 give DOP853 from eleven numbers", "[solved]") {
    check_solved(published_dop853(), 11);
}
