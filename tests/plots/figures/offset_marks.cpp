// SPDX-License-Identifier: BSD-3-Clause
//
// Lines of one colour bear marks, by which those that coincide are told apart.
#include "plots/figures/marks/offset_marks.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "plots/figures/gnuplot.hpp"
#include "plots/report/figures.hpp"
#include "tests/plots/drawn.hpp"
#include "tests/plots/folder.hpp"

using namespace kreisel;
using namespace kreisel::test;

namespace marks_of_lines {

/// Coincident lines from t = 0.01 to 100, of these styles.
Panel panel_of(const std::vector<int>& styles) {
    Panel panel{"", "t [s]", "e [m]", true, true, {}, {}, {}};
    for (const int style : styles) {
        Curve line{std::to_string(style), {}, style};
        for (int i = 0; i <= 400; ++i) { line.points.push_back({std::pow(10.0, 0.01 * i - 2), 1e-3}); }
        panel.curves.push_back(std::move(line));
    }
    return panel;
}

std::size_t plots_in(const std::vector<int>& styles) {
    const ResultFolder folder;
    make_folder(folder.path() / "figures");
    write_panels(folder.path() / "plotdata", {"page", "", {panel_of(styles)}});
    REQUIRE(run_gnuplot(folder.path(), plot_scripts(), "lines", "page").empty());
    const std::string svg = folder.read("figures/page.svg"), plot = "<g id=\"gnuplot_plot_";
    std::size_t count = 0;
    for (auto at = svg.find(plot); at != std::string::npos; at = svg.find(plot, at + 1)) { ++count; }
    return count;
}

}  // namespace marks_of_lines

TEST_CASE("lines of one colour bear marks at even distances, each between those of the others") {
    using marks_of_lines::panel_of;
    const Panel panel = panel_of({1, 8, 15, 2});  // 1, 8 and 15 are blue
    const auto marked = offset_marks(panel);
    REQUIRE(marked.size() == 4);
    CHECK(marked[3].empty());
    for (std::size_t k = 0; k < 6; ++k) {
        CHECK(marked[0].at(k) < marked[1].at(k));
        CHECK(marked[1].at(k) < marked[2].at(k));
        if (k > 0) { CHECK(marked[2].at(k - 1) < marked[0].at(k)); }
        // A sixth of the axis with its margins; the first is where the line begins.
        if (k > 1) { CHECK(std::abs(static_cast<double>(marked[0][k] - marked[0][k - 1]) - 400 * 1.12 / 6) < 2); }
    }
    CHECK(offset_marks(panel_of({1, 2, 3})) == std::vector<std::vector<std::size_t>>(3));
    Panel zero = panel;
    for (Point& point : zero.curves[1].points) { point.y = 0; }
    CHECK(offset_marks(zero)[1].empty());
}

TEST_CASE("marks of lines are in figures and report pages, of curves that are alone with their colours none") {
    using marks_of_lines::panel_of, marks_of_lines::plots_in;
    CHECK(plots_in({1, 8}) == 4);
    CHECK(plots_in({1, 2}) == 2);
    const auto curves = nlohmann::json::parse(json_value(panel_of({1, 8, 2}))).at("curves");
    CHECK(curves.at(1).at("marked") == offset_marks(panel_of({1, 8, 2}))[1]);
    CHECK_FALSE(curves.at(2).contains("marked"));
}
