// SPDX-License-Identifier: BSD-3-Clause
//
// What figures of curves show: which cells and samples, and the orders and growth laws in their legends.
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

#include "plots/figures/cells/select.hpp"
#include "plots/figures/kinds/curve_kind.hpp"
#include "records/reading/read_results.hpp"
#include "tests/plots/drawn.hpp"
#include "tests/plots/folder.hpp"

using namespace kreisel;
using namespace kreisel::test;

namespace {

/// The legend of the one curve whose error after h = 2^-6 ... 2^-11 is as given.
std::string legend_of(const std::function<double(double)>& error) {
    std::string lines;
    for (int k = 0; k < 6; ++k) {
        const long steps = 64L << k;
        lines += result_line("0" + std::to_string(k), steps, error(1.0 / static_cast<double>(steps))).dump() + "\n";
    }
    const ResultFolder folder;
    folder.write("results.jsonl", lines);
    const PanelFigure figure = panels_of({{"kind", "convergence"}}, read_results(folder.path()));
    REQUIRE(figure.panels.size() == 1);
    REQUIRE(figure.panels[0].curves.size() == 1);
    return figure.panels[0].curves[0].label;
}

/// A trajectory whose running maximum of the position defect is `defect(t)`, and its legend in the drift figure.
std::string growth_legend(const std::function<double(double)>& defect) {
    std::ostringstream text;
    text.precision(17);
    text << "t [s],defect.position [m],defect.position.max [m]\n";
    for (int i = 0; i <= 64; ++i) {
        const double t = i / 64.0;
        text << t << ',' << defect(t) << ',' << defect(t) << '\n';
    }
    const ResultFolder folder;
    folder.write("trajectories/aa.csv", text.str());
    folder.write(
        "results.jsonl",
        result_line("aa", 64, 0, {{"trajectory", "trajectories/aa.csv"}, {"metrics", {{"defect.position", 1}}}})
                .dump() +
            "\n");
    const PanelFigure figure =
        panels_of({{"kind", "drift"}, {"metric", "defect.position"}}, read_results(folder.path()));
    return figure.panels.at(0).curves.at(0).label;
}

}  // namespace

TEST_CASE("a legend says the order, or why there is none") {
    CHECK_THAT(legend_of([](double h) { return h * h; }), Catch::EndsWith(": 2.00 ± 0.00"));
    CHECK_THAT(legend_of([](double) { return 0.5; }), Catch::EndsWith(": pre-asymptotic"));
    CHECK_THAT(legend_of([](double) { return 1e-17; }), Catch::EndsWith(": floor"));
    CHECK_THAT(legend_of([](double h) { return h > 1.0 / 200 ? 1e-3 * std::pow(h, 3) : 1e-17; }),
               Catch::EndsWith(": too few points above round-off"));
    CHECK_THAT(legend_of([](double h) { return 1e-3 * h * (h < 1.0 / 600 ? std::pow(600 * h, 2) : 1); }),
               Catch::EndsWith(": not settled"));
    CHECK_THAT(legend_of([](double h) { return 1e-3 * std::pow(h, 0.1); }), Catch::EndsWith(": no convergence"));
}

TEST_CASE("a label among the options of a method stands for those that it settles") {
    const auto cell = [](const std::string& label, const std::string& b, const std::string& chart) {
        ResultRow row;
        row.method = "rkmk/tableau";
        row.options = std::map<std::string, std::string>{{"label", label}, {"b", b}, {"coordinates", chart}};
        return row;
    };
    const std::vector<ResultRow> rows = {cell("mine", "1", "exp"), cell("mine", "1", "cayley"), cell("", "0 1", "exp"),
                                         cell("", "1/2 1/2", "exp")};
    const CellNames names(rows);
    CHECK(names.axis(rows[0], "method") == "rkmk/tableau mine exp");
    CHECK(names.axis(rows[1], "method") == "rkmk/tableau mine cayley");
    CHECK(names.axis(rows[2], "method") == "rkmk/tableau b=0 1 exp");
    const std::vector<ResultRow> twice = {cell("mine", "1", "exp"), cell("mine", "0 1", "exp")};
    CHECK(CellNames(twice).axis(twice[1], "method") == "rkmk/tableau mine b=0 1");
}

TEST_CASE("fewer than four step sizes are too few, and a method that failed says how") {
    const ResultFolder folder;
    const auto failed = result_line("ff", 64, 0,
                                    {{"method", "cg/cg3a"},
                                     {"status", "left_chart"},
                                     {"detail", "step 3"},
                                     {"metrics", nullptr},
                                     {"final", nullptr}});
    folder.write("results.jsonl", result_line("aa", 64, 1e-3).dump() + "\n" + result_line("ab", 128, 1e-4).dump() +
                                      "\n" + failed.dump() + "\n");
    const PanelFigure figure = panels_of({{"kind", "convergence"}}, read_results(folder.path()));
    REQUIRE(figure.panels.at(0).curves.size() == 2);
    CHECK(figure.panels[0].curves[0].label == "rkmk/rk4: too few points");
    CHECK(figure.panels[0].curves[1].label == "cg/cg3a: left\\_chart");
    CHECK(figure.panels[0].curves[1].points.empty());
}

TEST_CASE("a legend says how a defect grows") {
    CHECK_THAT(growth_legend([](double) { return 0; }), Catch::EndsWith(": zero"));
    CHECK_THAT(growth_legend([](double) { return 1e-3; }), Catch::EndsWith(": constant"));
    CHECK_THAT(growth_legend([](double t) { return 1e-3 * t; }), Catch::EndsWith(": ∝ t^{1.00 ± 0.00}"));
    CHECK_THAT(growth_legend([](double t) { return 1e-17 * t; }), Catch::EndsWith(": round-off"));
    CHECK_THAT(growth_legend([](double t) { return t < 0.6 ? 1e-6 * t : 1e-3 * std::pow(t, 9); }),
               Catch::EndsWith(": no growth law"));
}

TEST_CASE("a cell that did not come to its end is drawn as far as it came, and says where that was") {
    const ResultFolder folder;
    folder.write("trajectories/aa.csv", trajectory_text());
    const nlohmann::json end = {{"trajectory", "trajectories/aa.csv"},
                                {"status", "singular_kkt"},
                                {"detail", "rows"},
                                {"t_reached", 0.61},
                                {"final", nullptr},
                                {"metrics", {{"defect.position", 1e-6}, {"invariant.energy", 1e-3}}}};
    folder.write("results.jsonl", result_line("aa", 50, 0, end).dump() + "\n");
    const Results results = read_results(folder.path());
    const PanelFigure drift = panels_of({{"kind", "drift"}, {"metric", "defect.position"}}, results);
    const PanelFigure energy = panels_of({{"kind", "invariants"}}, results);
    for (const PanelFigure* figure : {&drift, &energy}) {
        REQUIRE(figure->panels.size() == 1);
        REQUIRE(figure->panels[0].curves.size() == 1);
        CHECK_THAT(figure->panels[0].curves[0].label, Catch::EndsWith(": singular\\_kkt at 0.61 s"));
        CHECK(figure->panels[0].guides.empty());
    }
}

TEST_CASE("an order past the horizon of its reference says so") {
    const ResultFolder folder;
    const nlohmann::json past = {
        {"reference", {{"error", {{"error.position", 1e-20}}}, {"horizon", 0.5}, {"past_horizon", true}}}};
    folder.write("results.jsonl", convergence_lines(4, past));
    const PanelFigure figure = panels_of({{"kind", "convergence"}}, read_results(folder.path()));
    CHECK_THAT(figure.panels.at(0).curves.at(0).label, Catch::EndsWith(": 4.00 ± 0.00, past the horizon"));
}

TEST_CASE("select names cells by step count, label, problem, method, options and projection") {
    const ResultFolder folder;
    std::string lines;
    const auto add = [&](const std::string& cell, long steps, const nlohmann::json& changes) {
        lines += result_line(cell, steps, 1e-3, changes).dump() + "\n";
    };
    add("a0", 64, {});
    add("a1", 128, {{"label", "heavy"}});
    add("a2", 64, {{"options", {{"coordinates", "cayley"}}}});
    add("a3", 64, {{"projection", "terze"}, {"projection_options", {{"weight", "mass"}}}});
    add("a4", 64, {{"projection", "terze"}, {"projection_options", {{"weight", "identity"}}}});
    add("a5", 64, {{"status", "skipped"}, {"detail", "no"}, {"metrics", nullptr}, {"final", nullptr}});
    add("a6", 64, {{"status", "left_chart"}, {"detail", "no"}, {"metrics", nullptr}, {"final", nullptr}});
    folder.write("results.jsonl", lines);
    const Results results = read_results(folder.path());
    const auto cells = [&](const nlohmann::json& select, bool failed = false) {
        std::string text;
        const auto figure = figure_read_from({{"kind", "drift"}, {"select", select}});
        for (const ResultRow& row : selected_rows(*figure, results, failed)) { text += row.cell.substr(1); }
        return text;
    };
    CHECK(cells(nlohmann::json::object()) == "01234");
    CHECK(cells(nlohmann::json::object(), true) == "012346");
    CHECK(cells({{"steps", 128}}) == "1");
    CHECK(cells({{"problem", "heavy"}}) == "1");
    CHECK(cells({{"problem", {"heavy_top"}}, {"steps", 64}}) == "0234");
    CHECK(cells({{"problem", "heavy_top"}, {"steps", 128}}) == "1");
    CHECK(cells({{"method", "rkmk/rk4"}}) == "01234");
    CHECK(cells({{"projection", "terze"}}) == "34");
    CHECK(cells({{"projection", {"none", "terze"}}, {"formulation", "SO3xR3"}}) == "01234");
    const CellNames names(results.rows);
    const std::string cayley = names.axis(results.rows[2], "method");
    REQUIRE(cayley != "rkmk/rk4");
    CHECK(cells({{"method", cayley}}) == "2");
    CHECK(cells({{"projection", names.axis(results.rows[4], "projection")}}) == "4");
    CHECK_THROWS_AS(cells({{"steps", 128}, {"projection", "terze"}}), FigureError);
}

TEST_CASE("components are drawn until the time asked for, in one panel or stacked") {
    const ResultFolder folder;
    folder.write("trajectories/aa.csv", trajectory_text());
    folder.write("results.jsonl", result_line("aa", 50, 0, {{"trajectory", "trajectories/aa.csv"}}).dump() + "\n");
    const Results results = read_results(folder.path());
    const auto figure = [&](nlohmann::json more) {
        more["kind"] = "components";
        return panels_of(more, results);
    };
    const PanelFigure all = figure({{"quantity", "x"}});
    REQUIRE(all.panels.size() == 1);
    REQUIRE(all.panels[0].curves.size() == 3);
    CHECK(all.panels[0].y_label == "x [m]");
    CHECK(all.panels[0].curves[0].label == "x_1");
    CHECK(all.panels[0].curves[0].points.size() == 51);
    CHECK(all.panels[0].curves[0].points[50].y == Approx(-std::sin(1)));
    const PanelFigure early = figure({{"quantity", "omega"}, {"until", 0.5}, {"stacked", true}, {"columns", 1}});
    REQUIRE(early.panels.size() == 3);
    CHECK(early.panels[0].curves[0].points.size() == 26);
    CHECK(early.panels[2].y_label == "ω_3 [rad/s]");
    CHECK(early.panels[0].x_label.empty());
    CHECK(early.panels[2].x_label == "t [s]");
    CHECK(figure({{"quantity", "v"}, {"stacked", true}}).panels[0].x_label == "t [s]");
}

TEST_CASE("an axis is labelled with symbol and unit, even for an uncommon metric") {
    CHECK(metric_label("error.position", {}) == "|x − x_{ref}| [m]");
    CHECK(metric_label("error.position.max", {}) == "max |x − x_{ref}| [m]");
    CHECK(metric_label("invariant.energy", {{"invariant.energy", "J"}}) == "max |E − E_0| [J]");
    CHECK(metric_label("invariant.momentum_y", {{"invariant.momentum_y", "N s"}}) == "max |p_y − p_{y,0}| [N s]");
    CHECK(metric_label("invariant.body_momentum_norm", {}) == "max ||m| − |m|_0|");
    CHECK(metric_label("invariant.body_momentum_norm_big_wheel", {}) == "max ||m| − |m|_0|, big\\_wheel");
    CHECK(metric_label("invariant.spin_axial", {}) == "invariant.spin\\_axial");
    CHECK(metric_label("defect.position.final", {}) == "defect.position.final [m]");
}
