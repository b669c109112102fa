// SPDX-License-Identifier: BSD-3-Clause
//
// How a config says that a figure looks: ranges, scales, sizes, labels, order, styles, and which cells it shows.
#include <catch2/catch.hpp>
#include <map>
#include <set>

#include "plots/figures/layout.hpp"
#include "records/reading/read_results.hpp"
#include "support/errors.hpp"
#include "tests/plots/drawn.hpp"
#include "tests/plots/folder.hpp"

using namespace kreisel;
using namespace kreisel::test;

namespace looks {

/// Three methods of orders 4, 2 and 3, each with and without projection.
Results three_methods(const ResultFolder& folder) {
    std::string lines;
    int first = 0;
    for (const auto& [method, order] :
         std::vector<std::pair<std::string, int>>{{"rkmk/rk4", 4}, {"rkmk/midpoint", 2}, {"crouch_grossman/cg3a", 3}}) {
        for (const char* projection : {"none", "position_velocity"}) {
            lines += convergence_lines(order, {{"method", method}, {"projection", projection}}, first += 16);
        }
    }
    folder.write("results.jsonl", lines);
    return read_results(folder.path());
}

std::map<std::string, int> styles_of(const Panel& panel) {
    std::map<std::string, int> styles;
    for (const Curve& curve : panel.curves) { styles[curve.name] = curve.style; }
    return styles;
}

nlohmann::json convergence(nlohmann::json more) {
    more["kind"] = "convergence";
    return more;
}

std::string refusal(const nlohmann::json& figure) {
    try {
        figure_read_from(figure);
    } catch (const UsageError& error) { return error.what(); }
    return "";
}

}  // namespace looks

TEST_CASE("ranges, scales and sizes of a figure are those that its config gives") {
    const ResultFolder folder;
    const Results results = looks::three_methods(folder);
    const PanelFigure figure = panels_of(looks::convergence({{"x_range", {1e-4, 1}},
                                                             {"y_range", {1e-9, 1}},
                                                             {"y_scale", "linear"},
                                                             {"width", 120},
                                                             {"height", 35},
                                                             {"font_size", 6}}),
                                         results);
    const Panel& panel = figure.panels.at(0);
    CHECK(panel.log_x);
    CHECK_FALSE(panel.log_y);
    const auto [x, y] = axis_ranges(panel);
    CHECK((x.low == 1e-4 && x.high == 1 && y.low == 1e-9 && y.high == 1));
    const PageLayout page = layout_of(figure);
    CHECK(page.width == Approx(12));
    CHECK(page.height * (page.top[0] - page.bottom[0]) == Approx(3.5));
    CHECK(legend_row_height(figure) == Approx(0.8 * legend_row_height(PanelFigure{})));
    const PanelFigure column =
        panels_of(looks::convergence({{"width", "column"}, {"select", {{"projection", "none"}}}}), results);
    CHECK(layout_of(column).width == Approx(8.5));
    CHECK(layout_of(panels_of(looks::convergence({{"width", "page"}}), results)).width == Approx(17));
}

TEST_CASE("a range of a logarithmic axis begins above zero, and a legend fits the width that is given") {
    const ResultFolder folder;
    const Results results = looks::three_methods(folder);
    CHECK_THROWS_WITH(panels_of(looks::convergence({{"x_range", {0, 1}}}), results), Catch::Contains("begins above 0"));
    CHECK_NOTHROW(panels_of(looks::convergence({{"x_range", {0, 1}}, {"x_scale", "linear"}}), results));
    CHECK_THROWS_WITH(panels_of(looks::convergence({{"width", 40}}), results),
                      Catch::Contains("takes") && Catch::Contains("of 36 mm") && Catch::Contains("(\"legend\")"));
    CHECK_THAT(looks::refusal(looks::convergence({{"x_range", {1, 1e-3}}})),
               Catch::Contains("/figure/x_range: expected a lower and a higher number, got 1 and 0.001"));
    CHECK_THAT(looks::refusal(looks::convergence({{"width", "colum"}})), Catch::Contains("\"column\" (85 mm)"));
    CHECK_THAT(looks::refusal(looks::convergence({{"font_size", 3}})), Catch::Contains("from 4 to 20, got 3"));
    CHECK_THAT(looks::refusal(looks::convergence({{"order", {"a", "a"}}})), Catch::Contains("each name once"));
}

TEST_CASE("curves are labelled and ordered by their names in the legend") {
    const ResultFolder folder;
    const Results results = looks::three_methods(folder);
    const auto figure = looks::convergence({{"select", {{"projection", "none"}}},
                                            {"legend", {{"rkmk/rk4", "MK4 {^our_own}"}}},
                                            {"order", {"crouch_grossman/cg3a", "rkmk/rk4"}}});
    const Panel panel = panels_of(figure, results).panels.at(0);
    REQUIRE(panel.curves.size() == 3);
    CHECK(panel.curves[0].name == "crouch_grossman/cg3a");
    CHECK(panel.curves[1].label == enhanced_escape("MK4 {^our_own}") + ": 4.00 ± 0.00");
    CHECK(panel.curves[2].name == "rkmk/midpoint");
    CHECK_THROWS_WITH(panels_of(looks::convergence({{"legend", {{"rkmk/rk4", "a"}}}}), results),
                      Catch::Contains("\"legend\" names \"rkmk/rk4\", which is none of its curves (rkmk/rk4, no "));
    CHECK_THROWS_WITH(
        panels_of(looks::convergence({{"select", {{"projection", "none"}}}, {"order", {"rkmk/rk"}}}), results),
        Catch::Contains("did you mean \"rkmk/rk4\"?"));
}

TEST_CASE("a method has one colour in all figures of a run, and each curve of a figure a style") {
    const ResultFolder folder;
    const Results results = looks::three_methods(folder);
    const auto whole = looks::styles_of(panels_of(looks::convergence({}), results).panels.at(0));
    REQUIRE(whole.size() == 6);
    const auto colour = [](int style) { return (style - 1) % 7; };
    std::set<int> styles;
    for (const auto& [name, style] : whole) { CHECK(styles.insert(style).second); }
    CHECK(colour(whole.at("rkmk/midpoint, no projection")) == colour(whole.at("rkmk/midpoint, position_velocity")));
    const auto last = looks::styles_of(
        panels_of(looks::convergence(
                      {{"select",
                        {{"method", {"crouch_grossman/cg3a", "rkmk/midpoint"}}, {"projection", "position_velocity"}}}}),
                  results)
            .panels.at(0));
    REQUIRE(last.size() == 2);
    CHECK(colour(last.at("crouch_grossman/cg3a")) == colour(whole.at("crouch_grossman/cg3a, no projection")));
    CHECK(colour(last.at("rkmk/midpoint")) == colour(whole.at("rkmk/midpoint, no projection")));
    // One method: its variants differ in colour.
    const auto one =
        looks::styles_of(panels_of(looks::convergence({{"select", {{"method", "rkmk/rk4"}}}}), results).panels.at(0));
    CHECK(colour(one.at("no projection")) != colour(one.at("position_velocity")));
}

TEST_CASE("rows of a legend are higher where labels have something raised") {
    PanelFigure figure{"f", "", {Panel{"", "t", "x", false, false, {{"a: h", {}}, {"b: h\\^{", {}}}, {}, {}}}};
    const double plain = legend_row_height(figure);
    figure.panels[0].curves[0].label = "a: h^{4.00}";
    CHECK(legend_row_height(figure) > 1.15 * plain);
}

TEST_CASE("more than seven methods have styles of their own, too") {
    const ResultFolder folder;
    std::string lines;
    for (int i = 0; i < 17; ++i) {
        lines += convergence_lines(2, {{"method", "family/m" + std::to_string(i)}}, 16 * i);
    }
    folder.write("results.jsonl", lines);
    std::set<int> styles;
    for (const auto& [name, style] :
         looks::styles_of(panels_of(looks::convergence({}), read_results(folder.path())).panels.at(0))) {
        CHECK(styles.insert(style).second);
    }
    CHECK(styles.size() == 17);
}

TEST_CASE("cells are selected by parameters and options") {
    const ResultFolder folder;
    folder.write(
        "results.jsonl",
        convergence_lines(4, {{"parameters", {{"spin", 150.0}, {"lever", {0, 1, 0}}}}, {"label", "a"}}) +
            convergence_lines(2, {{"parameters", {{"spin", 40}, {"lever", {0, 2, 0}}}}, {"label", "b"}}, 16) +
            convergence_lines(3, {{"options", {{"coordinates", "cayley"}, {"rho", 0.5}, {"exact", true}}}}, 32));
    const Results results = read_results(folder.path());
    const auto count = [&](const nlohmann::json& select) {
        return panels_of(looks::convergence({{"select", select}}), results).panels.at(0).curves.size();
    };
    CHECK(count({{"parameter.spin", 150}}) == 1);
    CHECK(count({{"parameter.spin", {40, 150}}}) == 2);
    CHECK(count({{"parameter.lever", {{0, 1.0, 0}}}}) == 2);
    CHECK(count({{"option.coordinates", "cayley"}}) == 1);
    CHECK(count({{"option.rho", 0.5}, {"option.exact", true}}) == 1);
    CHECK_THROWS_AS(count({{"parameter.spin", 41}}), FigureError);
    CHECK_THROWS_AS(count({{"projection_option.every", 2}}), FigureError);
    CHECK_THAT(looks::refusal(looks::convergence({{"select", {{"option.", 1}}}})), Catch::Contains("option."));
    CHECK_THAT(looks::refusal(looks::convergence({{"select", {{"parameter.spin", nullptr}}}})),
               Catch::Contains("/figure/select/parameter.spin"));
}

TEST_CASE("what joints exert is drawn for all of them or one, forces and torques apart") {
    const ResultFolder folder;
    folder.write("results.jsonl", result_line("aa", 2, 0, {{"trajectory", "trajectories/aa.csv"}}).dump() + "\n");
    folder.write("trajectories/aa.csv",
                 "t [s],top.x1 [m],reaction.pin.force.1 [N],reaction.pin.torque.1 [N m],reaction.crank-rod.force.1 [N],"
                 "drive.motor.torque [N m]\n0,0,1,2,3,4\n1,0,5,6,7,8\n");
    const Results results = read_results(folder.path());
    const auto drawn = [&](nlohmann::json more) {
        more["kind"] = "components";
        return panels_of(more, results);
    };
    const PanelFigure all = drawn({{"quantity", "reactions"}, {"width", 80}, {"legend", {{"pin.force.1", "push"}}}});
    REQUIRE(all.panels.size() == 2);
    CHECK(layout_of(all).width == Approx(8));
    CHECK(all.panels[0].y_label == "F [N]");
    REQUIRE(all.panels[0].curves.size() == 2);
    CHECK(all.panels[0].curves[0].label == "push");
    CHECK(all.panels[0].curves[1].label == "F_{crank-rod.1}");
    CHECK(all.panels[0].curves[1].points.back().y == 7);
    CHECK(all.panels[1].y_label == "τ [N m]");
    const PanelFigure pin = drawn({{"quantity", "reactions"}, {"joint", "pin"}});
    CHECK((pin.panels.size() == 2 && pin.panels[0].curves.size() == 1));
    CHECK(drawn({{"quantity", "drives"}, {"joint", "motor"}}).panels.at(0).curves.at(0).label == "τ_{motor}");
    CHECK_THROWS_WITH(drawn({{"quantity", "reactions"}, {"joint", "pim"}}),
                      Catch::Contains("no reactions of \"pim\", but of pin, crank-rod; did you mean \"pin\"?"));
    CHECK_THROWS_WITH(drawn({{"joint", "pin"}}), Catch::Contains("x is of a \"body\", not a \"joint\""));
    CHECK_THROWS_WITH(drawn({{"quantity", "exerted"}}), Catch::Contains("no columns exerted.JOINT.1, ..."));
}

TEST_CASE("what a joint never exerts is left out, unless there is nothing else or it is named") {
    const ResultFolder folder;
    folder.write("results.jsonl", result_line("aa", 2, 0, {{"trajectory", "trajectories/aa.csv"}}).dump() + "\n");
    folder.write("trajectories/aa.csv",
                 "t [s],top.x1 [m],reaction.ball.force.1 [N],reaction.ball.force.2 [N],reaction.ball.torque.1 [N m],"
                 "drive.idle.torque [N m]\n0,0,1,0,0,0\n1,0,2,0,0,0\n");
    const Results results = read_results(folder.path());
    const auto panels_with = [&](nlohmann::json more) {
        more["kind"] = "components";
        return panels_of(more, results).panels;
    };
    const auto reactions = panels_with({{"quantity", "reactions"}});
    REQUIRE(reactions.size() == 1);
    CHECK(reactions[0].curves.size() == 2);  // a component that is zero stays with those that are not
    CHECK(panels_with({{"quantity", "reactions"}, {"order", {"ball.torque.1"}}}).size() == 2);
    CHECK(panels_with({{"quantity", "drives"}}).size() == 1);
}

TEST_CASE("a heat map is as wide as its config says, if its places find space") {
    const ResultFolder folder;
    const Results results = looks::three_methods(folder);
    const nlohmann::json select = {{"projection", "none"}};
    const auto settings = [&](nlohmann::json more) {
        more["kind"] = "heat_map", more["name"] = "f", more["select"] = select;
        figure_read_from(more)->write(results, folder.path());
        return folder.read("plotdata/f.gp");
    };
    // 20 letters of "crouch_grossman/cg3a", six places.
    CHECK_THAT(settings(nlohmann::json::object()), Catch::Contains("left_cm = 4.2\nright_cm = 2.9\nplace_width = 1.1"));
    CHECK_THAT(settings({{"width", "page"}}), Catch::Contains("place_width = 1.65"));
    CHECK_THAT(settings({{"font_size", 15}}), Catch::Contains("left_cm = 8.4\nright_cm = 5.8\nplace_width = 2.2"));
    CHECK_THROWS_WITH(settings({{"width", 85}}),
                      Catch::Contains("6 places beside each other need a \"width\" of 89 mm, got 85 mm"));
}
