// SPDX-License-Identifier: BSD-3-Clause
//
// Time and memory against the number of bodies: tables, fitted exponents, figures.
#include <catch2/catch.hpp>

#include "plots/laws/scaling.hpp"
#include "records/cell/line.hpp"
#include "records/reading/read_results.hpp"
#include "tests/plots/drawn.hpp"
#include "tests/plots/folder.hpp"
#include "tests/plots/named_tables.hpp"

using namespace kreisel;
using namespace kreisel::test;

namespace {

// time = 3e-6 N^power, memory = 1000 + 500 N
ResultRow timed_row(long bodies, double power, const std::string& formulation = "SE3") {
    ResultRow row = read_result_line(result_line("a1", 20, 0, {{"formulation", formulation}}).dump());
    const auto n = static_cast<double>(bodies);
    row.bodies = bodies;
    row.series = "chain";
    row.label = "chain, links = " + std::to_string(bodies);
    row.cost = {{"evaluations", 80}, {"step_s", 3e-6 * std::pow(n, power)}, {"memory", 1000 + 500 * n}};
    return row;
}

Results scaling_results() {
    Results results;
    results.name = "s";
    results.kind = "scaling";
    for (const long bodies : {512L, 2L, 8L, 64L, 4096L}) {
        results.rows.push_back(timed_row(bodies, bodies < 8 ? 3 : 1.25));  // below 8 another law, which must not enter
        results.rows.push_back(timed_row(bodies, 2, "SO3xR3"));
    }
    return results;
}

}  // namespace

TEST_CASE("the exponent is that of the law from eight bodies on, each formulation by itself") {
    const auto rows = by_series(scaling_results().rows);
    const auto curves = scaling_curves(rows);
    REQUIRE(curves.size() == 2);
    CHECK(curves[0].rows.front()->bodies == 2);
    CHECK(curves[0].rows.back()->bodies == 4096);
    const auto law = scaling_law(curves[0], "cost.step");
    REQUIRE(law);
    CHECK(law->exponent == Approx(1.25).epsilon(1e-12));
    CHECK(law->coefficient == Approx(3e-6).epsilon(1e-10));
    CHECK(law->error < 1e-12);
    CHECK(law->from == 8);
    CHECK(law->to == 4096);
    CHECK(scaling_law(curves[1], "cost.step")->exponent == Approx(2));
    CHECK(scaling_law(curves[1], "cost.step_per_body")->exponent == Approx(1));
    CHECK(scaling_law(curves[0], "cost.memory")->exponent == Approx(0.95).margin(0.05));
}

TEST_CASE("a law needs three numbers of bodies, and what was not measured is absent") {
    std::vector<ResultRow> rows = by_series({timed_row(8, 1), timed_row(16, 1), timed_row(4, 1), timed_row(16, 1)});
    CHECK_FALSE(scaling_law(scaling_curves(rows).front(), "cost.step"));
    rows.push_back(by_series({timed_row(32, 1)}).front());
    CHECK(scaling_law(scaling_curves(rows).front(), "cost.step")->exponent == Approx(1));
    rows.back().cost.erase("step_s");
    CHECK_FALSE(scaling_law(scaling_curves(rows).front(), "cost.step"));
    CHECK_FALSE(scaling_value(rows.back(), "cost.step_per_body"));
    CHECK(*scaling_value(rows.back(), "cost.memory_per_body") == Approx((1000 + 500 * 32) / 32.0));
}

TEST_CASE("the tables name series, bodies and exponents") {
    const Results results = scaling_results();
    const TextTable cells = tables_named("scaling", results).at(0).brief();
    const TextTable laws = tables_named("scaling_laws", results).at(0).full;
    CHECK(cells.rows.size() == 10);
    CHECK(cells.rows[2][0] == "chain");
    REQUIRE(laws.rows.size() == 2);
    const auto column = [&](const std::string& name) {
        return static_cast<std::size_t>(std::find(laws.columns.begin(), laws.columns.end(), name) -
                                        laws.columns.begin());
    };
    CHECK(laws.rows[0][column("from N")] == "8");
    CHECK(laws.rows[0][column("exponent of time")] == "1.250");
    CHECK(laws.rows[1][column("exponent of time")] == "2.000");
}

TEST_CASE("a figure of time and memory: one curve for each formulation, the exponent in its legend") {
    const PanelFigure figure = panels_of({{"kind", "scaling"}}, scaling_results());
    REQUIRE(figure.panels.size() == 2);
    CHECK(figure.panels[0].log_y);
    REQUIRE(figure.panels[0].curves.size() == 2);
    CHECK(figure.panels[0].curves[0].label == "SE3: ∝ N^{1.250 ± 0.000}");
    CHECK(figure.panels[0].curves[0].points.size() == 5);
    const nlohmann::json by_body = {{"kind", "scaling"}, {"metric", "cost.step_per_body"}};
    const PanelFigure per_body = panels_of(by_body, scaling_results());
    CHECK_FALSE(per_body.panels.at(0).log_y);
    CHECK(per_body.panels[0].from_zero);
    CHECK(per_body.panels[0].guides.empty());  // no line of zeros
    CHECK(per_body.panels[0].curves[0].label == "SE3");
    CHECK(per_body.panels[0].curves[1].points[0].y == Approx(3000 * 2));  // ns: 3e-6 * 2^2 / 2 s

    Results untimed = scaling_results();
    for (ResultRow& row : untimed.rows) { row.cost.clear(); }
    CHECK_THROWS_WITH(panels_of(by_body, untimed), Catch::Contains("journals"));
}

TEST_CASE("the axis of a cost per body starts at zero, and nothing is drawn there") {
    const nlohmann::json by_body = {{"kind", "scaling"}, {"name", "s"}, {"metric", "cost.memory_per_body"}};
    const ResultFolder folder;
    write_panels(folder.path(), panels_of(by_body, scaling_results()));
    CHECK(folder.read("s.gp").find("array y_low[1] = [0]\n") != std::string::npos);
    CHECK(folder.read("s.gp").find("array has_guides[1] = [0]\n") != std::string::npos);
}

TEST_CASE("times are read from the journals of the build that made the results") {
    const ResultFolder folder;
    const auto members = result_line("a1b2", 20, 0, {{"bodies", 4}, {"series", "chain"}, {"final", nullptr}});
    CellRecord cell = read_record(members.dump());
    cell.times = {.cpu_s = 1, .step_s = 2e-6, .memory = 4096};
    folder.write("results.jsonl", result_text(cell) + "\n");
    folder.write("journal.jsonl", journal_line(cell, "b") + "\n");
    folder.write(
        "manifest.json",
        nlohmann::json{{"config", {{"kind", "scaling"}, {"name", "s"}}}, {"program", {{"build", "b"}}}}.dump());
    const Results results = read_results(folder.path());
    REQUIRE(results.rows.size() == 1);
    CHECK(results.damage.empty());
    CHECK(results.rows[0].cost.at("step_s") == 2e-6);
    CHECK(results.rows[0].cost.at("memory") == 4096);
    CHECK(results.rows[0].series == "chain");
    folder.write("journal.jsonl", journal_line(cell, "another") + "\n");
    CHECK_FALSE(read_results(folder.path()).rows[0].cost.contains("step_s"));
}
