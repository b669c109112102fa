// SPDX-License-Identifier: BSD-3-Clause
//
// Tableaus as a config writes them: those of registered methods are read as they are and verified; each with a fault is
// turned down, at the option and in the words that tell it.
#include <catch2/catch.hpp>

#include "methods/conditions/exact_text.hpp"
#include "methods/conditions/tableau_options.hpp"
#include "methods/conditions/tableau_orders.hpp"
#include "methods/contract/method.hpp"
#include "tests/judges/conditions/registered.hpp"

using namespace kreisel;
using namespace kreisel::orders;

namespace {

std::string text_of(const Coefficient& entry) {
    if (entry.digits) return entry.digits;
    return std::to_string(entry.numerator) + (entry.denominator == 1 ? "" : "/" + std::to_string(entry.denominator));
}

std::string text_of(const std::vector<Coefficient>& row) {
    std::string text;
    for (const Coefficient& entry : row) text += (text.empty() ? "" : " ") + text_of(entry);
    return text;
}

/// Rows with all their zeros.
std::string text_of(std::vector<std::vector<Coefficient>> a) {
    std::string text;
    for (std::size_t i = 1; i < a.size(); ++i) {
        a[i].resize(i);
        text += (i > 1 ? "; " : "") + text_of(a[i]);
    }
    return text;
}

OptionValues options_of(const Method& method) {
    const Tableau& tableau = scheme_of<MuntheKaasScheme>(method)->tableau;
    const TableauOrders found = tableau_orders(tableau);
    return {{"a", text_of(tableau.a)},
            {"b", text_of(tableau.b)},
            {"b_hat", text_of(tableau.b_hat)},
            {"c", text_of(tableau.c)},
            {"order", static_cast<long>(found.step)},
            {"order_hat", static_cast<long>(found.embedded)},
            {"label", ""}};
}

/// "option: what speaks against it"; empty if nothing does.
std::string refusal(const OptionValues& options) {
    try {
        verified_tableau(with_defaults(options, tableau_options()));
        return "";
    } catch (const OptionError& error) { return error.option + ": " + error.what(); }
}

/// Heun's method with Euler's embedded, but for what is changed.
std::string changed_heun(OptionValues changes) {
    changes.insert({{"a", "1"}, {"b", "1/2 1/2"}, {"b_hat", "1 0"}, {"order", 2L}, {"order_hat", 1L}});
    return refusal(changes);
}

bool same(const std::vector<Coefficient>& a, const std::vector<Coefficient>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end());
}

}  // namespace

TEST_CASE("tableaus of methods are read as they are written, and verified", "[written_tableau]") {
    for (const char* name : {"rkmk/euler", "rkmk/heun", "rkmk/rk4_38", "rkmk/bs3", "rkmk/fehlberg4", "rkmk/cash_karp5",
                             "rkmk/dopri5", "rkmk/tsit5", "rkmk/verner6"}) {
        INFO(name);
        const Tableau& tableau = scheme_of<MuntheKaasScheme>(method(name))->tableau;
        const Tableau& read = verified_tableau(options_of(method(name)));
        REQUIRE(read.a.size() == tableau.a.size());
        for (std::size_t i = 0; i < read.a.size(); ++i) {
            std::vector<Coefficient> row = tableau.a[i];
            row.resize(i);
            CHECK(same(read.a[i], row));
        }
        CHECK(same(read.b, tableau.b));
        CHECK(same(read.b_hat, tableau.b_hat));
        CHECK(estimate_of_tableau(options_of(method(name))) == method(name).description.estimate);
    }
}

TEST_CASE("decimals are the fractions they print, and rows may begin with the first", "[written_tableau]") {
    CHECK(refusal({}) == "");
    CHECK(refusal({{"a", "0.5; 0 0.50; 0 0 1.0"}}) == "");
    CHECK(refusal({{"a", "; 1/2; 0 1/2; 0 0 1"}, {"c", "0 1/2 0.5 1"}}) == "");
    CHECK(refusal({{"a", ""}, {"b", "1"}, {"order", 1L}}) == "");
    CHECK(read_exact("-0.125") == Rational(-1, 8));
    CHECK(read_exact("010/08") == Rational(5, 4));
    std::deque<std::string> digits;
    CHECK(read_coefficient("0.0", digits).is_zero());
    CHECK(read_coefficient("-0.161", digits) == Coefficient(-161, 1000));
    CHECK(read_coefficient("2/4", digits).denominator == 4);
    CHECK(digits.empty());
    CHECK(exact(read_coefficient("0.12345678901234567890", digits)) == read_exact("0.12345678901234567890"));
    const Coefficient third = read_coefficient("10000000000000000000000/30000000000000000000000", digits);
    CHECK(abs(Rational(exact(third) - Rational(1, 3))) < rounding(true));
    CHECK(digits.size() == 1);
}

TEST_CASE("decimals of 40 digits may be rounded, shorter ones are exact", "[written_tableau]") {
    const std::string sixth(38, '6'), third(40, '3');
    const std::string b = "0.1" + sixth + "7 0." + third + " 0." + third + " 0.1" + sixth + "7";
    CHECK(refusal({{"b", b}}) == "");
    CHECK(refusal({{"b", "0.16666666666666667 0.33333333333333333 0.33333333333333333 0.16666666666666667"}}) ==
          "order: expected 2, the order that the weights have, got 4: sum b_i c_i^2 = 1/3 (tree [t t]) is missed by "
          "1.67e-18");
}

TEST_CASE("an order that a tableau does not have is refused with the condition it misses", "[written_tableau]") {
    const std::string has = ", the order that the weights have, got ";
    CHECK(refusal({{"order", 3L}}) == "order: expected 4" + has + "3");
    CHECK(refusal({{"order", 5L}}) ==
          "order: expected 4" + has + "5: sum b_i c_i^4 = 1/5 (tree [t t t t]) is missed by 0.00833");
    CHECK(refusal({{"a", "1/2; 0 1/2; 0 1/4 3/4"}}) ==
          "order: expected 3" + has + "4: sum b_i a_ij a_jk c_k = 1/24 (tree [[[t]]]) is missed by -0.0104");
    CHECK(refusal({{"a", "1/2; 1/4 1/4; 0 0 1"}}) ==
          "order: expected 2" + has + "4: sum b_i a_ij c_j = 1/6 (tree [[t]]) is missed by -0.0417");
    CHECK(refusal({{"b", "1/6 1/3 1/3 1/7"}}) ==
          "order: expected 0" + has + "4: sum b_i = 1 (tree t) is missed by -0.0238");
    CHECK(changed_heun({{"order_hat", 2L}}) ==
          "order_hat: expected 1" + has + "2: sum b_hat_i c_i = 1/2 (tree [t]) is missed by -0.5");
    CHECK(changed_heun({{"b_hat", "1/2 1/2"}, {"order_hat", 2L}}) ==
          "order_hat: expected another order than that of b, of which the error is estimated, got 2 twice");
}

TEST_CASE("a misprint is named by its row", "[written_tableau]") {
    CHECK(refusal({{"a", "1/2; 0 1/3; 0 0 1"}, {"c", "0 1/2 1/2 1"}}) ==
          "c: expected the sum of each row of a, got 1/2 for row 3, which sums to 1/3");
    CHECK(refusal({{"a", "1/2; 1/2; 0 0 1"}}) == "a: expected 2 entries in row 3, those before the diagonal, got 1");
    CHECK(refusal({{"a", "1/2; 0 1/2 0; 0 0 1"}}) ==
          "a: expected 2 entries in row 3, those before the diagonal, got 3");
    CHECK(refusal({{"a", "1/2; 0 1/2"}}) == "b: expected 3 entries, one for each row of a, got 4");
    CHECK(refusal({{"a", "1/2; 0 1/0; 0 0 1"}}) == "a: expected a denominator that is not 0, got \"1/0\" in row 3");
    CHECK(refusal({{"a", "1/2; 0 1//2; 0 0 1"}}) ==
          "a: expected a whole number, a fraction or a decimal (\"-1\", \"-25/108\", \"0.25\"), got \"1//2\" in row 3");
    for (const char* wrong : {"1e-1", ".5", "5.", "+1", "0x1", "1/-2", "--1", "-", "nan"}) {
        CHECK_THROWS_AS(read_exact(wrong), std::invalid_argument);
        CHECK(refusal({{"b", std::string("1/6 1/3 1/3 ") + wrong}}).starts_with("b: expected a whole number"));
    }
}

TEST_CASE("weights of an embedded solution and their order come together", "[written_tableau]") {
    CHECK(changed_heun({}) == "");
    CHECK(changed_heun({{"order_hat", 0L}}) == "order_hat: expected the order of the weights b_hat, got none");
    CHECK(changed_heun({{"b_hat", ""}}) == "order_hat: expected 0, as there is no b_hat, got 1");
    CHECK(changed_heun({{"b_hat", "1"}}) == "b_hat: expected 2 entries, one for each row of a, got 1");
    CHECK(estimate_of_tableau(with_defaults({}, tableau_options())) == 0);
}

TEST_CASE("conditions are told in the symbols of the literature", "[written_tableau]") {
    const RootedTrees trees(5);
    std::vector<std::string> weights, texts;
    for (const std::size_t tree : trees.of_order(4)) {
        weights.push_back(trees.weight_text(tree, "b"));
        texts.push_back(trees.text(tree));
    }
    CHECK(weights == std::vector<std::string>{"b_i c_i^3", "b_i c_i a_ij c_j", "b_i a_ij c_j^2", "b_i a_ij a_jk c_k"});
    CHECK(texts == std::vector<std::string>{"[t t t]", "[t [t]]", "[[t t]]", "[[[t]]]"});
    CHECK(trees.weight_text(trees.of_order(5)[4], "b") == "b_i a_ij c_j a_ik c_k");
}
