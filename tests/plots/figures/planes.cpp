// SPDX-License-Identifier: BSD-3-Clause
//
// Figures of two quantities against each other, of errors along the way, and of a metric over two axes.
#include <catch2/catch.hpp>
#include <cmath>

#include "plots/plot.hpp"
#include "records/reading/read_results.hpp"
#include "tests/plots/drawn.hpp"
#include "tests/plots/folder.hpp"

using namespace kreisel;
using namespace kreisel::test;

namespace planes {

/// A body on the unit circle, x = (cos t, sin t, 0), several times around, with an error t^2 1e-6 from the first sample
/// on.
std::string circle(int samples, double end) {
    std::ostringstream text;
    text.precision(17);
    text << "t [s],ball.x1 [m],ball.x2 [m],ball.x3 [m],ball.v1 [m/s],ball.v2 [m/s],ball.v3 [m/s],ball.omega1 [rad/s],"
            "ball.omega2 [rad/s],ball.omega3 [rad/s],error.position [m]\n";
    for (int i = 0; i <= samples; ++i) {
        const double t = end * i / samples, c = std::cos(t), s = std::sin(t);
        text << t << ',' << c << ',' << s << ",0," << -s << ',' << c << ",0,0,0,1,";
        if (i > 0) { text << 1e-6 * t * (end - t); }
        text << '\n';
    }
    return text.str();
}

Results on_circle(const ResultFolder& folder) {
    folder.write("trajectories/aa.csv", circle(1000, 20));
    folder.write("results.jsonl", result_line("aa", 1000, 0, {{"trajectory", "trajectories/aa.csv"}}).dump() + "\n");
    return read_results(folder.path());
}

}  // namespace planes

TEST_CASE("a phase portrait shows two components of a body against each other") {
    const ResultFolder folder;
    const Results results = planes::on_circle(folder);
    const Panel panel =
        panels_of({{"kind", "phase_portrait"}, {"x", "x1"}, {"y", "v2"}, {"until", 6}}, results).panels.at(0);
    CHECK(panel.x_label == "x_1 [m]");
    CHECK(panel.y_label == "v_2 [m/s]");
    REQUIRE(panel.curves.size() == 1);
    CHECK(panel.curves[0].points.size() == 301);
    for (const Point& point : panel.curves[0].points) { CHECK(point.x == point.y); }
    CHECK_THROWS_WITH(panels_of({{"kind", "phase_portrait"}, {"body", "bal"}}, results),
                      Catch::Contains("no body \"bal\""));
}

TEST_CASE("a Poincare section shows where a component passes a value") {
    const ResultFolder folder;
    const Results results = planes::on_circle(folder);
    const auto points = [&](const char* direction, double at) {
        return panels_of({{"kind", "poincare"},
                          {"section", "x2"},
                          {"at", at},
                          {"direction", direction},
                          {"x", "x1"},
                          {"y", "v2"}},
                         results)
            .panels.at(0)
            .curves.at(0)
            .points;
    };
    // sin t = 1/2 with cos t > 0 at t = pi/6 + 2 k pi <= 20: k = 0, 1, 2, 3; with cos t < 0 at 5 pi/6 + 2 k pi: k = 0,
    // 1, 2.
    const auto up = points("up", 0.5), down = points("down", 0.5);
    REQUIRE(up.size() == 4);
    REQUIRE(down.size() == 3);
    for (const Point& point : up) { CHECK(point.x == Approx(std::sqrt(0.75)).margin(1e-4)); }
    for (const Point& point : down) { CHECK(point.y == Approx(-std::sqrt(0.75)).margin(1e-4)); }
    CHECK(points("both", 0.5).size() == 7);
    CHECK_THROWS_WITH(points("both", 1.5), Catch::Contains("no trajectory passes x2 = 1.5 either way"));
    CHECK_THROWS_WITH(points("down", -1.5), Catch::Contains("no trajectory passes x2 = -1.5 downwards"));
    // It starts on the surface, which does not count as a passage.
    CHECK(points("up", 0).size() == 3);
}

TEST_CASE("errors are drawn along the way, or the largest so far") {
    const ResultFolder folder;
    const Results results = planes::on_circle(folder);
    const auto points = [&](const char* metric) {
        return panels_of({{"kind", "errors"}, {"metric", metric}}, results).panels.at(0).curves.at(0).points;
    };
    const auto along = points("error.position"), largest = points("error.position.max");
    REQUIRE(along.size() == 1001);
    CHECK(std::isnan(along.front().y));
    CHECK(along[250].y == Approx(1e-6 * 5 * 15));
    CHECK(along.back().y == 0);
    CHECK(largest[250].y == along[250].y);
    CHECK(largest.back().y == Approx(1e-6 * 10 * 10));
    CHECK_THROWS_WITH(panels_of({{"kind", "errors"}, {"metric", "error.rotation"}}, results),
                      Catch::Contains("error.*.max"));
    CHECK(figure_read_from({{"kind", "errors"}, {"metric", "error.rotation"}})->drawn_metrics() ==
          std::vector<std::string>{"error.rotation.max"});
}

TEST_CASE("a heat map shows a metric over two axes, and refuses two cells in one place") {
    const ResultFolder folder;
    folder.write("results.jsonl", convergence_lines(4, {{"parameters", {{"spin", 40}}}}) +
                                      convergence_lines(2, {{"parameters", {{"spin", 5}}}, {"label", "b"}}, 16));
    const auto drawn_with = [&](nlohmann::json figure) {
        figure["kind"] = "heat_map";
        figure["name"] = "map";
        folder.manifest({{"name", "map"}, {"kind", "convergence"}, {"figure", figure}});
        return plot_command({.folders = {folder.path()}, .figure = {}, .output = {}});
    };
    REQUIRE(drawn_with({{"x", "steps"}, {"y", "parameter.spin"}}) == Exit::ok);
    const std::string settings = folder.read("plotdata/map.gp"), data = folder.read("plotdata/map.dat");
    CHECK_THAT(settings, Catch::Contains("array x_value[6] = ['64','128','256','512','1024','2048']"));
    CHECK_THAT(settings, Catch::Contains("array y_value[2] = ['5','40']"));
    CHECK_THAT(data, Catch::Contains("1 1 0.000244140625 2.4e-04\n"));  // spin 5, of order 2, h = 1/64
    CHECK(folder.has("figures/map.pdf"));
    CHECK(folder.has("figures/map.svg"));
    CHECK(drawn_with({{"x", "steps"}, {"y", "parameter.spin"}, {"metric", {"error.position", "error.omega"}}}) ==
          Exit::ok);
    CHECK_THAT(folder.read("plotdata/map.gp"), Catch::Contains("array value_label[1]"));  // no cell has the second
    CHECK(drawn_with({{"x", "steps"}, {"y", "parameter.spin"}, {"metric", {"error.position", "invariant.energy"}}}) ==
          Exit::ok);
    CHECK_THAT(folder.read("plotdata/map.gp"), Catch::Contains("array value_label[2]"));
    CHECK_THAT(folder.read("plotdata/map.dat"), Catch::Contains("\n\n\n1 2 0.001 1.0e-03\n"));
    CHECK(drawn_with({{"x", "formulation"}, {"y", "method"}}) == Exit::cells_failed);
    CHECK(drawn_with({{"x", "parameter.spin"}, {"y", "h"}, {"scale", "linear"}}) == Exit::ok);
}
