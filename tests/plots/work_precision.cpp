// SPDX-License-Identifier: BSD-3-Clause
//
// What an accuracy costs: interpolated on curves with known crossings, tabulated and drawn; tolerance proportionality.
#include "plots/laws/work_precision.hpp"
#include "records/reading/read_results.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "plots/laws/convergence.hpp"
#include "plots/laws/proportionality.hpp"
#include "records/cell/line.hpp"
#include "tests/plots/curves.hpp"
#include "tests/plots/drawn.hpp"
#include "tests/plots/folder.hpp"
#include "tests/plots/named_tables.hpp"

using namespace kreisel;
using namespace kreisel::test;

namespace {

// error = coefficient (cost/100)^-order at costs 100, 1000, ..., never below `least`.
std::vector<WorkPoint> power_curve(double coefficient, double order, int levels, double least = 0) {
    std::vector<WorkPoint> points;
    for (int k = 0; k < levels; ++k) {
        points.push_back({100 * std::pow(10.0, k), std::max(least, coefficient * std::pow(10.0, -order * k))});
    }
    return points;
}

// A cell of constant steps whose error is that of order p, at four solves a step; CPU time 1e-6 s a solve.
ResultRow priced_row(const std::string& method, long steps, double order) {
    const nlohmann::json changes = {
        {"method", method}, {"cost", {{"evaluations", 4 * steps}, {"exponentials", 3 * steps}, {"brackets", 0}}}};
    ResultRow row =
        read_result_line(result_line("aa", steps, std::pow(static_cast<double>(steps), -order), changes).dump());
    row.cost["run_s"] = 4e-6 * static_cast<double>(steps);
    return row;
}

// A cell to a tolerance, whose error is factor tolerance^slope.
ResultRow tolerance_row(double tolerance, double factor, double slope, long accepted = 100) {
    const nlohmann::json changes = {
        {"method", "fake/pair"}, {"steps", nullptr},
        {"h", nullptr},          {"tolerance", tolerance},
        {"controller", "pi"},    {"cost", {{"evaluations", 6 * accepted}, {"accepted", accepted}}}};
    return read_result_line(result_line("bb", 1, factor * std::pow(tolerance, slope), changes).dump());
}

Results priced_results() {
    Results results;
    results.name = "w";
    results.kind = "work_precision";
    results.units = {{"error.position", "m"}};
    for (long steps = 10; steps <= 10'000; steps *= 10) {
        results.rows.push_back(priced_row("rkmk/rk4", steps, 4));       // passes 1e-12
        results.rows.push_back(priced_row("rkmk/midpoint", steps, 2));  // ends at 1e-8
    }
    for (int k = 1; k <= 8; ++k) { results.rows.push_back(tolerance_row(std::pow(10.0, -k), 10, 1, 20L << k)); }
    return results;
}

std::vector<std::vector<std::string>> rows_with(const TextTable& table, const std::string& column,
                                                const std::string& value) {
    const auto found = std::find(table.columns.begin(), table.columns.end(), column);
    REQUIRE(found != table.columns.end());
    const auto at = static_cast<std::size_t>(found - table.columns.begin());
    std::vector<std::vector<std::string>> rows;
    for (const auto& row : table.rows) {
        if (row[at] == value) { rows.push_back(row); }
    }
    return rows;
}

Proportionality law_of(const std::vector<ResultRow>& rows) {
    const auto groups = group_by_method(rows);
    REQUIRE(groups.size() == 1);
    return proportionality_of(groups.front(), "error.position");
}

}  // namespace

TEST_CASE("the cost of an accuracy is that of the power law between its neighbours") {
    const auto points = power_curve(1, 4, 5);  // 1, 1e-4, ... 1e-16 at 1e2 ... 1e6
    CHECK(cost_at(points, 1e-6)->cost == Approx(100 * std::pow(10.0, 6 / 4.0)).epsilon(1e-12));
    CHECK(cost_at(points, 1e-9)->cost == Approx(100 * std::pow(10.0, 9 / 4.0)).epsilon(1e-12));
    CHECK(cost_at(points, 1e-12)->cost == Approx(1e5).epsilon(1e-12));
    CHECK_FALSE(cost_at(points, 1e-6)->at_most);
    auto shuffled = points;
    std::swap(shuffled[0], shuffled[3]);
    CHECK(cost_at(shuffled, 1e-9)->cost == cost_at(points, 1e-9)->cost);
    // piecewise: the neighbours count, not a line through all
    const std::vector<WorkPoint> bent = {{1, 1}, {10, 1e-2}, {100, 1e-10}};
    CHECK(cost_at(bent, 1e-6)->cost == Approx(10 * std::sqrt(10.0)));
    CHECK(cost_at(bent, 1e-1)->cost == Approx(std::sqrt(10.0)));
}

TEST_CASE("a curve that never reaches an accuracy has no cost there") {
    CHECK_FALSE(cost_at(power_curve(1, 4, 5, 2e-9), 1e-9));  // stays just above
    CHECK(cost_at(power_curve(1, 4, 5, 2e-9), 1e-6));
    CHECK_FALSE(cost_at(power_curve(1, 4, 2), 1e-6));  // would reach it by extrapolation
    CHECK_FALSE(cost_at({}, 1e-3));
    CHECK_FALSE(cost_at({{0, 1}, {0, 1e-9}}, 1e-6));  // brackets of a method that takes none
}

TEST_CASE("a curve that begins beyond an accuracy has a bound there") {
    const auto points = power_curve(1e-5, 4, 3);
    REQUIRE(cost_at(points, 1e-3));
    CHECK(cost_at(points, 1e-3)->at_most);
    CHECK(cost_at(points, 1e-3)->cost == 100);
    CHECK_FALSE(cost_at(points, 1e-5)->at_most);  // it is there exactly
    CHECK(cost_at({{1, 1}, {2, 0}}, 1e-9)->at_most);
}

TEST_CASE("the first crossing by cost counts, and round-off after it does not") {
    const std::vector<WorkPoint> floor = {{1, 1e-2}, {10, 1e-14}, {100, 1e-11}};
    CHECK(cost_at(floor, 1e-12)->cost == Approx(std::pow(10.0, 10.0 / 12)));
}

TEST_CASE("the table names costs, marks the lowest, and says what is not reached") {
    const TablePair pair = tables_named("work_precision", priced_results()).at(0);
    const auto solves = rows_with(pair.brief(), "cost", "solves of the dynamics");
    REQUIRE(solves.size() == 3);
    const std::size_t accuracy = CellNames::axes().size() + 1;
    CHECK(solves[0][2] == "rkmk/rk4");
    CHECK(solves[0][accuracy] == "<= 4.00e+01*");
    CHECK(solves[0][accuracy + 1] == "1.26e+02*");  // 4 (1e6)^{1/4}
    CHECK(solves[0][accuracy + 2] == "7.11e+02*");  // 4 (1e9)^{1/4}
    CHECK(solves[1][accuracy] == "1.26e+02");       // 4 (1e3)^{1/2}
    CHECK(solves[1][accuracy + 1] == "4.00e+03");
    CHECK(solves[1][accuracy + 2] == "not reached");
    CHECK(solves[1][accuracy + 3] == "not reached");
    CHECK(solves[2][2] == "fake/pair");
    CHECK(solves[2][accuracy + 3] == "not reached");
    CHECK(rows_with(pair.brief(), "cost", "CPU time [s]").size() == 2);
    const auto lowest = rows_with(pair.full, "lowest", "yes");
    for (const auto& row : lowest) { CHECK(std::find(row.begin(), row.end(), "not reached") == row.end()); }
    for (const auto& row : rows_with(pair.full, "cost", "brackets")) {
        CHECK(std::find(row.begin(), row.end(), "not reached") != row.end());
    }
}

TEST_CASE("costs on different problems do not compete") {
    Results results;
    results.kind = "work_precision";
    for (long steps = 10; steps <= 10'000; steps *= 10) {
        results.rows.push_back(priced_row("rkmk/rk4", steps, 4));
        results.rows.push_back(priced_row("rkmk/midpoint", steps, 2));
        results.rows.back().label = "another";
    }
    const TablePair pair = tables_named("work_precision", results).at(0);
    CHECK(pair.brief().rows.at(1).at(CellNames::axes().size() + 2) == "4.00e+03*");
}

TEST_CASE("a table of costs is for experiments that measure them") {
    Results results = priced_results();
    const auto applies = [&] {
        const auto& all = result_tables();
        return std::find_if(all.begin(), all.end(), [](const auto& one) { return one.name == "work_precision"; })
            ->applies(results);
    };
    CHECK(applies());
    results.kind = "convergence";
    CHECK_FALSE(applies());
}

TEST_CASE("errors are drawn against what they cost") {
    const Results results = priced_results();
    const PanelFigure figure = panels_of({{"kind", "work_precision"}}, results);
    REQUIRE(figure.panels.size() == 1);
    const Panel& panel = figure.panels[0];
    CHECK((panel.log_x && panel.log_y));
    CHECK(panel.x_label == "solves of the dynamics");
    REQUIRE(panel.curves.size() == 3);
    CHECK(panel.curves[0].label == "rkmk/rk4");
    CHECK(panel.curves[0].points[1].x == 400);
    CHECK(panel.curves[0].points[1].y == Approx(1e-8));
    CHECK(panel.marks.empty());

    const PanelFigure labelled = panels_of({{"kind", "work_precision"}, {"labels", true}, {"x", "cpu"}}, results);
    REQUIRE(labelled.panels.at(0).curves.size() == 2);  // the adaptive cells have no time here
    CHECK(labelled.panels[0].x_label == "CPU time [s]");
    CHECK(labelled.panels[0].marks.size() == 8);
    CHECK(labelled.panels[0].marks[2].text == "1000");

    const PanelFigure several = panels_of({{"kind", "work_precision"},
                                           {"metric", {"error.position", "invariant.energy"}},
                                           {"select", {{"tolerance", 1e-3}}}},
                                          results);
    REQUIRE(several.panels.size() == 2);
    CHECK(several.panels[0].curves.size() == 1);
    CHECK(several.panels[0].curves[0].points.size() == 1);
    CHECK_THROWS_WITH(panels_of({{"kind", "work_precision"}, {"x", "newton_iterations"}}, results),
                      Catch::Contains("no such metric and cost"));
}

TEST_CASE("a convergence figure has tolerances or costs on its axis") {
    Results results = priced_results();
    const Panel mixed = panels_of({{"kind", "convergence"}}, results).panels.at(0);
    CHECK(mixed.x_label == "h [s], or tolerance");
    REQUIRE(mixed.curves.size() == 3);
    CHECK(mixed.curves[0].points[0].x == 0.1);
    CHECK(mixed.curves[2].points[0].x == 0.1);
    CHECK(mixed.curves[2].label == "fake/pair: ∝ tolerance^{1.00 ± 0.00}");
    const Panel priced = panels_of({{"kind", "convergence"}, {"x", "exponentials"}}, results).panels.at(0);
    CHECK(priced.curves.size() == 2);
    CHECK(priced.curves[0].points[0].x == 30);
    CHECK(priced.guides.empty());  // a slope over costs is not an order
    std::erase_if(results.rows, [](const ResultRow& row) { return !row.adaptive(); });
    CHECK(panels_of({{"kind", "convergence"}}, results).panels.at(0).x_label == "tolerance");
}

TEST_CASE("one method with constant steps and with tolerances makes two curves") {
    Results results = priced_results();
    for (ResultRow& row : results.rows) { row.method = "fake/pair"; }
    const CellNames names(results.rows);
    std::vector<std::string> said;
    for (const CellGroup& group : group_by_method(results.rows)) {
        said.push_back(names.axis(group.front(), "method"));
    }
    CHECK(said == std::vector<std::string>{"fake/pair", "fake/pair adaptive"});
}

TEST_CASE("tolerance proportionality is a slope of its own") {
    std::vector<ResultRow> rows;
    for (int k = 2; k <= 8; ++k) {
        rows.push_back(tolerance_row(std::pow(10.0, -k), 0.1 * std::pow(1.5, noise(k)), 0.8));
    }
    const Proportionality law = law_of(rows);
    REQUIRE(law.slope);
    CHECK(*law.slope == Approx(0.8).margin(0.05));
    CHECK(law.uncertainty > 0);
    CHECK(law.from == Approx(1e-2));
    CHECK(law.to == Approx(1e-8));
    CHECK_FALSE(order_of(group_by_method(rows).front(), "error.position").order);
    CHECK(order_of(group_by_method(rows).front(), "error.position").points.empty());
    Results results;
    results.rows = rows;
    const TablePair pair = tables_named("proportionality", results).at(0);
    REQUIRE(pair.brief().rows.size() == 1);
    CHECK(pair.brief().rows[0].back().find("[0.01–1e-08]") != std::string::npos);
    CHECK(tables_named("orders", results).at(0).full.rows.empty());
}

TEST_CASE("errors that do not follow their tolerance have no proportionality, and the reason is given") {
    const auto reason = [](double (*error)(int), long accepted) {
        std::vector<ResultRow> rows;
        for (int k = 2; k <= 9; ++k) { rows.push_back(tolerance_row(std::pow(10.0, -k), error(k), 0, accepted)); }
        const Proportionality law = law_of(rows);
        CHECK_FALSE(law.slope);
        return law.reason;
    };
    CHECK_THAT(reason([](int k) { return k < 5 ? std::pow(10.0, -k) : 1e-9; }, 100), Catch::Contains("no power law"));
    CHECK_THAT(reason([](int k) { return std::pow(10.0, -k); }, 19), Catch::Contains("0 admissible"));
    CHECK_THAT(reason([](int) { return 1e-13; }, 100), Catch::Contains("0 admissible"));
    CHECK_THAT(reason([](int k) { return k < 5 ? std::pow(10.0, -k) : 1e-15; }, 100), Catch::Contains("admissible"));
}

TEST_CASE("CPU times are read from the journals of the build that made the results") {
    const ResultFolder folder;
    CellRecord cell = read_record(result_line("a1b2", 20, 1e-6).dump());
    cell.times = {.cpu_s = 1, .run_s = 2e-3};
    folder.write("results.jsonl", result_text(cell) + "\n");
    folder.write("journal.jsonl", journal_line(cell, "b") + "\n");
    const nlohmann::json config = {{"kind", "work_precision"}, {"name", "s"}};
    folder.write("manifest.json", nlohmann::json{{"config", config}, {"program", {{"build", "b"}}}}.dump());
    CHECK(read_results(folder.path()).rows.at(0).cost.at("run_s") == 2e-3);
}
