// SPDX-License-Identifier: BSD-3-Clause
//
// Heat maps and figures in space as the page of a report holds them.
#include "plots/report/places.hpp"
#include "records/reading/read_results.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "plots/report/figures.hpp"
#include "tests/plots/drawn.hpp"
#include "tests/plots/folder.hpp"

using namespace kreisel;
using namespace kreisel::test;

namespace places {

nlohmann::json figure_of(const ResultFolder& folder, nlohmann::json figure) {
    folder.manifest({{"name", "f"}, {"kind", "convergence"}, {"figure", figure}});
    const ReportFigures figures = report_figures(read_results(folder.path()));
    return nlohmann::json::parse(figures.json).at(0);
}

}  // namespace places

TEST_CASE("a heat map is on the page with a map for each metric that cells have") {
    const ResultFolder folder;
    folder.write("results.jsonl", convergence_lines(4, {{"parameters", {{"spin", 40}}}}) +
                                      convergence_lines(2, {{"parameters", {{"spin", 5}}}, {"label", "b"}}, 16));
    const nlohmann::json metrics = {"error.position", "error.omega", "invariant.energy"};
    const auto heat =
        places::figure_of(folder, {{"kind", "heat_map"}, {"x", "steps"}, {"y", "parameter.spin"}, {"metric", metrics}});
    const auto& data = heat.at("heat");
    CHECK(data.at("y_values") == nlohmann::json({"5", "40"}));
    CHECK(data.at("x_values").size() == 6);
    CHECK(data.at("log") == true);
    REQUIRE(data.at("maps").size() == 2);
    CHECK(data.at("maps").at(0).at("places").size() == 12);
    CHECK(data.at("maps").at(0).at("places").at(6) == nlohmann::json({0, 0, 0.000244140625}));
    CHECK_THAT(data.at("maps").at(1).at("label").get<std::string>(), Catch::Contains("E"));
    CHECK_FALSE(data.contains("width"));
    const nlohmann::json sizes = {{"kind", "heat_map"}, {"x", "steps"}, {"y", "parameter.spin"},
                                  {"width", "page"},    {"height", 30}, {"font_size", 9}};
    const auto sized = places::figure_of(folder, sizes).at("heat");
    CHECK((sized.at("width") == 17 && sized.at("axes_height") == 3 && sized.at("font_size") == 9));
    const auto none = places::figure_of(folder, {{"kind", "heat_map"}, {"metric", "error.omega"}});
    CHECK_THAT(none.at("not_drawn").get<std::string>(), Catch::Contains("no selected cell has error.omega"));
}

TEST_CASE("a heat map of zeros says that its scale cannot show them") {
    const ResultFolder folder;
    folder.write("results.jsonl", result_line("a1", 64, 0).dump() + "\n");
    const nlohmann::json map = {{"kind", "heat_map"}, {"scale", "log"}};
    CHECK_THAT(places::figure_of(folder, map).at("not_drawn").get<std::string>(),
               Catch::Contains("all values of error.position are 0, which no logarithmic scale shows"));
    CHECK(places::figure_of(folder, {{"kind", "heat_map"}, {"scale", "linear"}}).contains("heat"));
}

TEST_CASE("a path in space is on the page with its shadow's floor, and thinned") {
    const ResultFolder folder;
    folder.write("results.jsonl", result_line("a1", 64, 1e-3, {{"trajectory", "trajectories/a1.csv"}}).dump() + "\n");
    folder.write("trajectories/a1.csv", trajectory_text(1200));
    const auto space = places::figure_of(folder, {{"kind", "path3d"}, {"view", {50, 20}}}).at("space");
    const auto &t = space.at("t"), &path = space.at("path");
    CHECK(t.size() == path.size());
    CHECK((t.size() > 1000 && t.size() <= 2000));
    CHECK(t.back() == 1);
    CHECK(std::abs(path.back().at(0).get<double>() + std::sin(1)) < 1e-5);
    CHECK(space.at("view") == nlohmann::json({50, 20}));
    for (std::size_t k = 0; k < 3; ++k) {
        CHECK(space.at("high").at(k).get<double>() - space.at("low").at(k).get<double>() ==
              Approx(space.at("high").at(0).get<double>() - space.at("low").at(0).get<double>()));
    }
    CHECK(space.at("lines").empty());
}

TEST_CASE("outlines in space are left out by instants where they are many") {
    SpaceData data{.path = {{0, 1}, {{0, 0, 0}, {1, 0, 0}}, {}}};
    for (int i = 0; i < 100; ++i) {
        for (int k = 0; k < 2; ++k) { data.lines.push_back({0.5 * i, std::vector<Point3>(100, Point3{1, 2, 3})}); }
    }
    const auto lines = nlohmann::json::parse(space_json(data)).at("lines");
    std::set<double> instants;
    for (const auto& line : lines) { instants.insert(line.at(0).get<double>()); }
    CHECK(lines.size() == 2 * instants.size());  // an instant as a whole
    CHECK(lines.size() * 100 <= 8000);
    CHECK(*instants.begin() == 0);
}
