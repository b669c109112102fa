// SPDX-License-Identifier: BSD-3-Clause
//
// Several folders in one figure, figures from files, and curves from elsewhere beside those of cells.
#include <catch2/catch.hpp>
#include <cmath>

#include "plots/figures/cells/joined.hpp"
#include "plots/figures/overlay/overlay_files.hpp"
#include "plots/plot.hpp"
#include "records/reading/read_results.hpp"
#include "tests/plots/drawn.hpp"
#include "tests/plots/folder.hpp"

using namespace kreisel;
using namespace kreisel::test;

namespace several {

void write_experiment(const ResultFolder& folder, const std::string& name, int order) {
    folder.write("results.jsonl", convergence_lines(order));
    folder.manifest({{"name", name}, {"kind", "convergence"}});
}

/// The message with which a figure that names a CSV file is refused; empty where it is not.
std::string refusal(const std::string& csv, const nlohmann::json& overlay) {
    const ResultFolder folder;
    folder.write("data.csv", csv);
    folder.write("figure.json", nlohmann::json{{"kind", "convergence"}, {"overlay", overlay}}.dump());
    try {
        figures_in_file(folder.path() / "figure.json", "figure");
    } catch (const UsageError& error) { return error.what(); }
    return "";
}

const nlohmann::json of_file = {{"file", "data.csv"}, {"x", "h"}, {"y", "error"}, {"label", "elsewhere"}};

}  // namespace several

TEST_CASE("cells of several folders stand side by side under the names of their experiments") {
    const ResultFolder a, b, c;
    several::write_experiment(a, "first", 4);
    several::write_experiment(b, "second", 2);
    several::write_experiment(c, "second", 3);
    const Results two = joined({read_results(a.path()), read_results(b.path())});
    const Panel panel = panels_of({{"kind", "convergence"}}, two).panels.at(0);
    REQUIRE(panel.curves.size() == 2);
    CHECK(panel.curves[0].label == "first: 4.00 ± 0.00");
    CHECK(panel.curves[1].label == "second: 2.00 ± 0.00");
    CHECK(panels_of({{"kind", "convergence"}, {"facet", "results"}}, two).panels.size() == 2);
    CHECK(panels_of({{"kind", "convergence"}, {"select", {{"results", "second"}}}}, two).panels.at(0).curves.size() ==
          1);
    const Results three = joined({read_results(a.path()), read_results(b.path()), read_results(c.path())});
    CHECK(panels_of({{"kind", "convergence"}}, three).panels.at(0).curves.at(2).name ==
          "second (" + c.path().string() + ")");
    const Results alone = joined({read_results(a.path())});
    CHECK(panels_of({{"kind", "convergence"}}, alone).panels.at(0).curves.at(0).name == "rkmk/rk4");
}

TEST_CASE("kreisel plot draws several folders by a file, into the first one or elsewhere") {
    const ResultFolder a, b, elsewhere;
    several::write_experiment(a, "first", 4);
    several::write_experiment(b, "second", 2);
    elsewhere.write("both.json", R"({"kind": "convergence", "width": "column", "title": "Both"})");
    const PlotSettings into_first{{a.path(), b.path()}, elsewhere.path() / "both.json", {}};
    CHECK(plot_command(into_first) == Exit::ok);
    CHECK(a.has("figures/both.pdf"));
    CHECK_FALSE(b.has("figures/both.pdf"));
    CHECK_THAT(a.read("plotdata/both.gp"), Catch::Contains("second: 2.00 ± 0.00") && Catch::Contains("width_cm = 8.5"));
    const PlotSettings apart{{a.path(), b.path()}, elsewhere.path() / "both.json", elsewhere.path() / "drawn"};
    CHECK(plot_command(apart) == Exit::ok);
    CHECK(elsewhere.has("drawn/figures/both.svg"));
    CHECK_THROWS_WITH(plot_command({{a.path(), b.path()}, {}, {}}), Catch::Contains("expected --figure FILE"));
    CHECK_THROWS_WITH(plot_command({{a.path(), a.path()}, elsewhere.path() / "both.json", {}}),
                      Catch::Contains("expected each folder once"));
}

TEST_CASE("samples are read from the folder of their cell") {
    const ResultFolder a, b;
    for (const ResultFolder* folder : {&a, &b}) {
        folder->write("results.jsonl", result_line("aa", 50, 0, {{"trajectory", "trajectories/aa.csv"}}).dump() + "\n");
        folder->manifest({{"name", folder == &a ? "first" : "second"}, {"kind", "trajectory"}});
    }
    a.write("trajectories/aa.csv", trajectory_text(50));
    b.write("trajectories/aa.csv", trajectory_text(20));
    const Results both = joined({read_results(a.path()), read_results(b.path())});
    const Panel panel = panels_of({{"kind", "phase_portrait"}, {"y", "x2"}}, both).panels.at(0);
    REQUIRE(panel.curves.size() == 2);
    CHECK(panel.curves[0].points.size() == 51);
    CHECK(panel.curves[1].points.size() == 21);
}

TEST_CASE("an overlay is a curve beside those of cells, in all panels or one") {
    const ResultFolder folder;
    several::write_experiment(folder, "first", 4);
    const Results results = read_results(folder.path());
    const nlohmann::json points = {{0.01, 1e-3}, {0.1, nullptr}, {0.2, 1e-1}};
    const auto figure = [&](const nlohmann::json& overlay) {
        return panels_of(
            {{"kind", "work_precision"}, {"metric", {"error.position", "invariant.energy"}}, {"overlay", overlay}},
            results);
    };
    const PanelFigure all = figure({{"label", "a_b"}, {"points", points}});
    REQUIRE(all.panels.size() == 2);
    for (const Panel& panel : all.panels) {
        REQUIRE(panel.curves.size() == 2);
        CHECK(panel.curves[1].label == enhanced_escape("a_b"));
        CHECK(panel.curves[1].style != panel.curves[0].style);
        CHECK(panel.curves[1].points[2].y == 1e-1);
        CHECK(std::isnan(panel.curves[1].points[1].y));
    }
    const PanelFigure one = figure({{"label", "b"}, {"points", points}, {"panel", 2}});
    CHECK(one.panels[0].curves.size() == 1);
    CHECK(one.panels[1].curves.size() == 2);
    CHECK_THROWS_WITH(figure({{"label", "b"}, {"points", points}, {"panel", 3}}), Catch::Contains("there are 2"));
}

TEST_CASE("the points of a CSV file stand in the document that names it") {
    const ResultFolder folder;
    folder.write("data.csv", "name,h [s],\"error, all [m]\"\r\nx,0.1,1e-3\r\ny,0.05,\r\n\r\nz,0.025,+2e-5\r\n");
    nlohmann::json overlay = several::of_file;
    overlay["y"] = "error, all";
    folder.write("figure.json", nlohmann::json{{"kind", "convergence"}, {"overlay", {overlay}}}.dump());
    Document document = read_document(folder.path() / "figure.json");
    insert_overlay_files(document, "");
    CHECK(document.value["overlay"][0] ==
          nlohmann::json({{"label", "elsewhere"}, {"points", {{0.1, 1e-3}, {0.05, nullptr}, {0.025, 2e-5}}}}));
}

TEST_CASE("what an overlay names and is not there is refused") {
    const std::string good = "h,error\n0.1,1e-3\n";
    CHECK(several::refusal(good, several::of_file).empty());
    const auto changed = [&](const char* key, const char* value) {
        nlohmann::json overlay = several::of_file;
        overlay[key] = value;
        return several::refusal(good, overlay);
    };
    CHECK_THAT(changed("file", "other.csv"), Catch::Contains("/overlay/file: expected the path of a CSV file"));
    CHECK_THAT(changed("y", "eror"),
               Catch::Contains("/overlay/y: expected a column of") && Catch::Contains("(h, error)"));
    CHECK_THAT(several::refusal("h,error\n0.1\n", several::of_file),
               Catch::Contains("data.csv:2: expected 2 fields, got 1"));
    CHECK_THAT(several::refusal("h,error\n0.1,nan\n", several::of_file),
               Catch::Contains("data.csv:2: expected a number"));
    CHECK_THAT(several::refusal("h,error\n0.1,1e400\n", several::of_file),
               Catch::Contains("data.csv:2: expected a number"));
    CHECK_THAT(several::refusal("h,error\n", several::of_file), Catch::Contains("expected points, got titles only"));
    CHECK_THAT(several::refusal("", several::of_file), Catch::Contains("expected a line of titles"));
    CHECK_THAT(several::refusal(good, {{"file", "data.csv"}, {"label", "a"}, {"x", "h"}}), Catch::Contains("/overlay"));
    CHECK_THAT(several::refusal(good, {{"points", {{1, 2, 3}}}, {"label", "a"}}), Catch::Contains("/overlay/points/0"));
    CHECK_THAT(several::refusal(good, {{"points", {{1, 2}}}}), Catch::Contains("label"));
}
