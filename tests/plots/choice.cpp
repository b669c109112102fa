// SPDX-License-Identifier: BSD-3-Clause
//
// Tables with chosen columns and rows, under names to be printed.
#include <catch2/catch.hpp>

#include "plots/tables/choice.hpp"
#include "records/reading/read_results.hpp"
#include "support/errors.hpp"
#include "tests/plots/folder.hpp"

using namespace kreisel;
using namespace kreisel::test;

namespace choice_tests {

namespace {

Results two_methods() {
    const ResultFolder folder;
    folder.write("results.jsonl", convergence_lines(4) + convergence_lines(2, {{"method", "rkmk/midpoint"}}, 16));
    return read_results(folder.path());
}

std::string refusal(const TableChoice& choice) {
    try {
        return "taken: " + chosen_table(two_methods(), choice);
    } catch (const UsageError& error) { return error.what(); }
}

}  // namespace

TEST_CASE("a table has the columns and rows that were chosen, in that order, under the names given") {
    TableChoice choice{.table = "errors",
                       .columns = {"steps", "method", "error.position"},
                       .rows = {"method=*mid*", "steps=64", "steps=2048"},
                       .names = {"rkmk/midpoint=MK midpoint", "steps=n", "error.position [m]=$e_q$"},
                       .format = "csv"};
    CHECK(chosen_table(two_methods(), choice).starts_with("n,method,$e_q$\n64,MK midpoint,0.000244140625\n2048,"));
    choice.format = "latex";
    const std::string latex = chosen_table(two_methods(), choice);
    CHECK_THAT(latex,
               Catch::Contains("n & method & \\$e\\_q\\$ \\\\\n\\midrule\n64 & MK midpoint & $2.44\\cdot10^{-4}$"));
    CHECK_THAT(latex, !Catch::Contains("rkmk/rk4") && !Catch::Contains("128"));
    choice.format = "markdown";
    CHECK_THAT(chosen_table(two_methods(), choice), Catch::Contains("| 64 | MK midpoint | 2.44e-04 |"));
    CHECK_THAT(chosen_table(two_methods(), {.table = "errors"}), Catch::Contains("rkmk/rk4"));
}

TEST_CASE("what a table does not have is refused by what it has") {
    CHECK_THAT(refusal({.table = "errrors"}), Catch::Contains("--table: expected a table of these results (") &&
                                                  Catch::Contains("got \"errrors\"; did you mean \"errors\"?"));
    CHECK_THAT(refusal({.table = "errors", .columns = {"steps", "metod"}}),
               Catch::Contains("--columns: expected a column of the table errors (problem, formulation, method") &&
                   Catch::Contains("did you mean \"method\"?"));
    CHECK(refusal({.table = "errors", .rows = {"rkmk/rk4"}}) == "--rows: expected COLUMN=PATTERN, got \"rkmk/rk4\"");
    CHECK_THAT(refusal({.table = "errors", .rows = {"metod=rkmk/rk4"}}), Catch::Contains("did you mean \"method\"?"));
    CHECK(refusal({.table = "errors", .rows = {"method=rkmk/rk5"}}) ==
          "--rows: no row of the table errors has method=rkmk/rk5");
    CHECK(refusal({.table = "errors", .names = {"RK4"}}) == "--names: expected TEXT=NAME, got \"RK4\"");
}

}  // namespace choice_tests
