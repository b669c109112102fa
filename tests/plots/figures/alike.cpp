// SPDX-License-Identifier: BSD-3-Clause
//
// Panels that show the same are drawn once, those that differ visibly apart.
#include "plots/figures/alike.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "plots/report/figures.hpp"
#include "records/reading/read_results.hpp"
#include "tests/plots/drawn.hpp"
#include "tests/plots/folder.hpp"

using namespace kreisel;
using namespace kreisel::test;

namespace alike {

/// A logarithmic panel with one curve from (1, 1) to (100, 1e-4), whose second point is off by a part of the y axis.
Panel panel_of(const std::string& title, double off = 0) {
    Panel panel{title, "h [s]", "e [m]", true, true, {}, {}, {}};
    panel.x_range = {1, 100}, panel.y_range = {1e-5, 1};
    panel.curves.push_back({"a", {{1, 1}, {10, 1e-2 * std::pow(10, 5 * off)}, {100, 1e-4}}});
    return panel;
}

std::vector<std::string> titles_of(const std::vector<Panel>& panels) {
    std::vector<std::string> titles;
    for (const Panel& panel : each_look_once(panels)) { titles.push_back(panel.title); }
    return titles;
}

using Titles = std::vector<std::string>;

}  // namespace alike

TEST_CASE("panels whose curves are less than half a mark apart are drawn once, under all titles") {
    using alike::panel_of, alike::titles_of, alike::Titles;
    CHECK(titles_of({panel_of("SO3"), panel_of("SO3xR3", 0.01), panel_of("SE3", -0.01)}) == Titles{"SO3, SO3xR3, SE3"});
    CHECK(titles_of({panel_of("SO3"), panel_of("SE3", 0.02), panel_of("SO3xR3")}) == Titles{"SO3, SO3xR3", "SE3"});
    Panel lost = panel_of("lost");
    lost.curves[0].points[1].y = std::nan("");
    CHECK(titles_of({panel_of("whole"), lost}).size() == 2);
    CHECK(titles_of({lost, lost}).size() == 1);
}

TEST_CASE("panels with other axes, legends, fitted points or without titles stay apart") {
    using alike::panel_of, alike::titles_of;
    const Panel one = panel_of("a");
    REQUIRE(look_alike(one, panel_of("b")));
    const auto stays_apart = [&](auto change) {
        Panel other = panel_of("b");
        change(other);
        return titles_of({one, other}).size() == 2;
    };
    CHECK(stays_apart([](Panel& other) { other.title.clear(); }));
    CHECK(stays_apart([](Panel& other) { other.y_label = "e [rad]"; }));
    CHECK(stays_apart([](Panel& other) { other.y_range = {1e-6, 1}; }));
    CHECK(stays_apart([](Panel& other) { other.log_x = false; }));
    CHECK(stays_apart([](Panel& other) { other.curves[0].label = "b"; }));
    CHECK(stays_apart([](Panel& other) { other.curves[0].style = 2; }));
    CHECK(stays_apart([](Panel& other) { other.curves[0].fitted = {{1, 1}}; }));
    CHECK(stays_apart([](Panel& other) { other.curves[0].points.pop_back(); }));
    CHECK(stays_apart([](Panel& other) { other.curves.push_back(other.curves[0]); }));
}

TEST_CASE("formulations with the same errors have one panel in figures and on the page of a report") {
    const ResultFolder folder;
    std::string lines;
    int first = 0;
    for (const auto& [formulation, order] : {std::pair("SO3", 4), std::pair("SO3xR3", 4), std::pair("SE3", 3)}) {
        lines += convergence_lines(order, {{"formulation", formulation}}, first += 16);
    }
    folder.write("results.jsonl", lines);
    const nlohmann::json figure = {{"kind", "convergence"}, {"facet", "formulation"}};
    folder.manifest({{"name", "f"}, {"kind", "convergence"}, {"figure", figure}});
    const Results results = read_results(folder.path());
    const PanelFigure drawn = panels_of(figure, results);
    REQUIRE(drawn.panels.size() == 2);
    CHECK(drawn.panels[0].title == "SO3, SO3xR3");
    CHECK(drawn.panels[1].title == "SE3");
    const auto page = nlohmann::json::parse(report_figures(results).json).at(0).at("panels");
    CHECK((page.size() == 2 && page.at(0).at("title") == "SO3, SO3xR3"));
}
