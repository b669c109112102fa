// SPDX-License-Identifier: BSD-3-Clause
//
// Labels are data in every table format.
#include "plots/tables/text.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "plots/tables/latex.hpp"

using namespace kreisel;

namespace {

TextTable one_cell(const std::string& text) { return {"t", "title", {"column"}, {{text}}, {}}; }

std::string latex_body(const std::string& text) {
    const std::string all = latex_text(one_cell(text));
    const auto begin = all.find("\\midrule\n") + 9;
    return all.substr(begin, all.find(" \\\\\n\\bottomrule") - begin);
}

std::string csv_body(const std::string& text) {
    const std::string all = csv_text(one_cell(text));
    return all.substr(7, all.size() - 8);
}

}  // namespace

TEST_CASE("LaTeX shows labels and never runs them") {
    CHECK(latex_body("a_b") == "a\\_b");
    CHECK(latex_body("\\input{/etc/passwd}") == "\\textbackslash{}input\\{/etc/passwd\\}");
    CHECK(latex_body("100 % & $x$ # ^ ~") == "100 \\% \\& \\$x\\$ \\# \\textasciicircum{} \\textasciitilde{}");
    CHECK(latex_body("a\nb") == "a?b");
    CHECK(latex_body("3.99 ± 0.02 [1–2]") == "3.99 $\\pm$ 0.02 [1--2]");
    CHECK(latex_body("żółw ×") == "żółw ×");
    CHECK(latex_body("Δλ ≤ ħ 中") == "$\\Delta$$\\lambda$ $\\leq$ [U+0127] [U+4E2D]");
    CHECK(latex_body("[1] *") == "{}[1] *");
    CHECK(latex_body("*[1]") == "{}*[1]");
    CHECK(latex_body("a--b 'c' \"d\" `e`") ==
          "a-{}-b \\textquotesingle{}c\\textquotesingle{} \\texttt{\\char34}d\\texttt{\\char34} "
          "\\textasciigrave{}e\\textasciigrave{}");
    CHECK(latex_body("a,b,,c") == "a,b,{},c");
    CHECK(latex_escaped("it's") == "it's");
    CHECK(latex_body("1.15e-03") == "$1.15\\cdot10^{-3}$");
    CHECK(latex_body("-2e+10") == "$-2\\cdot10^{10}$");
    CHECK(latex_body("1.00e+00") == "$1.00\\cdot10^{0}$");
}

TEST_CASE("columns of numbers are aligned at the right, whether marked, absent or in words here and there") {
    const TextTable table{
        "t",
        "title",
        {"method", "cost", "order", "status"},
        {{"a", "1.15e-03*", "4", "ok"}, {"b", "<= 2.00e-03", "-", "ok"}, {"c", "not reached", "-", "1"}},
        {}};
    CHECK(number_columns(table) == std::vector<bool>{false, true, true, false});
    CHECK_THAT(latex_text(table), Catch::Contains("\\begin{tabular}{lrrl}") &&
                                      Catch::Contains("a & $1.15\\cdot10^{-3}$* & 4 & ok") &&
                                      Catch::Contains("c & not reached\\phantom{*} & --"));
    CHECK_THAT(markdown_text(table), Catch::Contains("| --- | ---: | ---: | --- |\n"));
}

TEST_CASE("a wide table is set as small as it needs in LaTeX, its heads in several lines") {
    TextTable table{"t", "title", {"method", "error.position.max [m]"}, {{"a", "1.15e-03"}}, {}};
    CHECK_THAT(latex_text(table), !Catch::Contains("\\sbox") && Catch::Contains("& error.position.max [m] "));
    table.columns.insert(table.columns.end(), 3, "error.rotation [rad]");
    table.rows[0].insert(table.rows[0].end(), 3, "1");
    CHECK_THAT(latex_text(table), Catch::Contains("\\footnotesize") && Catch::Contains("\\rotatebox") &&
                                      Catch::Contains("method & \\shortstack[r]{error.\\\\position.\\\\max [m]} & "
                                                      "\\shortstack[r]{error.\\\\rotation \\\\{}[rad]}"));
}

TEST_CASE("CSV quotes what needs quotes and defuses formulas") {
    CHECK(csv_body("a,b") == "\"a,b\"");
    CHECK(csv_body("say \"x\"") == "\"say \"\"x\"\"\"");
    CHECK(csv_body("=cmd|' /C calc'!A0") == "'=cmd|' /C calc'!A0");
    CHECK(csv_body("+1+1") == "'+1+1");
    CHECK(csv_body("@SUM(A1)") == "'@SUM(A1)");
    CHECK(csv_body("-1.5e-07") == "-1.5e-07");
    CHECK(csv_body("-") == "-");
}

TEST_CASE("Markdown keeps a table a table") {
    const std::string text = markdown_text(one_cell("a|b <script> `x` [y](z)\nq"));
    CHECK(text.find("| a\\|b &lt;script\\> \\`x\\` \\[y\\](z)?q |\n") != std::string::npos);
    CHECK(std::count(text.begin(), text.end(), '\n') == 5);
}

TEST_CASE("numbers read back, and absent ones stay absent") {
    CHECK(exact_number(0.1) == "0.1");
    CHECK(exact_number(1.0 / 3) == "0.3333333333333333");
    CHECK(exact_number(std::nan("")).empty());
    CHECK(short_number(1.1499e-3) == "1.15e-03");
    CHECK(short_number(0) == "0");
    CHECK(short_number(std::nan("")) == "-");
}

TEST_CASE("columns with one value become a note") {
    const TextTable table{"t", "title", {"problem", "method", "x"}, {{"top", "a", "1"}, {"top", "b", "1"}}, {"how"}};
    const TextTable brief = without_constant_columns(table, {"problem", "method"});
    CHECK(brief.columns == std::vector<std::string>{"method", "x"});
    CHECK(brief.rows == std::vector<std::vector<std::string>>{{"a", "1"}, {"b", "1"}});
    CHECK(brief.notes == std::vector<std::string>{"problem: top.", "how"});
    CHECK(terminal_text(brief).find("problem: top.") != std::string::npos);
}
