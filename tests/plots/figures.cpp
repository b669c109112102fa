// SPDX-License-Identifier: BSD-3-Clause
//
// Figures: what a config may request, what gnuplot is given, and that nothing in a label is executed.
#include <catch2/catch.hpp>
#include <cmath>

#include "plots/figures/enhanced_text.hpp"
#include "plots/figures/kinds/drawn_top.hpp"
#include "plots/figures/kinds/slope_triangle.hpp"
#include "plots/figures/settings.hpp"
#include "plots/figures/spec.hpp"
#include "plots/plot.hpp"
#include "records/json/strict.hpp"
#include "records/reading/read_results.hpp"
#include "tests/plots/folder.hpp"

using namespace kreisel;
using namespace kreisel::test;

namespace {

constexpr Exit drawn = Exit::ok, not_drawn = Exit::cells_failed;

// The first issue of a "figure" value: pointer and expectation.
std::string first_issue(const std::string& figure) {
    const Document document = parse_document("test.json", "{\"figure\": " + figure + "}");
    Diagnostics diagnostics(document);
    read_figures(Node(document.value["figure"], "/figure", diagnostics), "figure");
    return diagnostics.empty() ? ""
                               : diagnostics.issues().front().pointer + ": " + diagnostics.issues().front().expected;
}

bool is_file_of(const ResultFolder& folder, const std::string& name, const std::string& magic) {
    return folder.read(name).find(magic) != std::string::npos;
}

void check_drawn(const ResultFolder& folder, const std::string& name) {
    INFO(name);
    CHECK(is_file_of(folder, "figures/" + name + ".pdf", "%PDF"));
    CHECK(is_file_of(folder, "figures/" + name + ".svg", "<svg"));
    CHECK(is_file_of(folder, "figures/" + name + ".png", "PNG"));
    CHECK(!folder.has("plotdata/" + name + ".log"));
}

}  // namespace

TEST_CASE("good figures pass") {
    CHECK(first_issue(R"({"kind": "path3d", "body": "top", "view": [60, 30], "until": 1})") == "");
    CHECK(first_issue(R"([{"kind": "motion", "name": "a", "instants": 5, "lever": [0, 0, 1]}, {"kind": "drift", )"
                      R"("name": "b"}])") == "");
    CHECK(first_issue(R"({"kind": "convergence", "metric": ["error.position", "error.omega"], "facet": "formulation",
                          "select": {"steps": [10, 20], "method": "rkmk/rk4"}})") == "");
    CHECK(first_issue(R"({"kind": "invariants", "metric": "invariant.energy", "relative": true})") == "");
}

TEST_CASE("bad figures are refused at the error") {
    const std::pair<const char*, const char*> cases[] = {
        {"{}", "/figure"},
        {"[]", ""},
        {"3", "/figure"},
        {R"({"kind": "pie"})", "/figure/kind"},
        {R"({"kind": 3})", "/figure/kind"},
        {R"({"kind": "drift", "colour": "red"})", "/figure/colour"},
        {R"({"kind": "drift", "instants": 3})", "/figure/instants"},
        {R"({"kind": "drift", "name": "../x"})", "/figure/name"},
        {R"({"kind": "drift", "name": "| rm"})", "/figure/name"},
        {R"({"kind": "drift", "name": ""})", "/figure/name"},
        {R"({"kind": "drift", "title": "a\nb"})", "/figure/title"},
        {R"({"kind": "drift", "metric": "error.position"})", "/figure/metric"},
        {R"({"kind": "drift", "metric": ["defect.position", 1]})", "/figure/metric/1"},
        {R"({"kind": "drift", "facet": "steps"})", "/figure/facet"},
        {R"({"kind": "drift", "select": {"step": 3}})", "/figure/select/step"},
        {R"({"kind": "drift", "select": {"steps": -3}})", "/figure/select/steps"},
        {R"({"kind": "drift", "columns": 9})", "/figure/columns"},
        {R"({"kind": "motion", "instants": 2.5})", "/figure/instants"},
        {R"({"kind": "motion", "radius": -1})", "/figure/radius"},
        {R"({"kind": "motion", "lever": [0, 1]})", "/figure/lever"},
        {R"({"kind": "motion", "lever": [0, 1, "x"]})", "/figure/lever/2"},
        {R"({"kind": "motion", "until": 0})", "/figure/until"},
        {R"({"kind": "components", "quantity": "y"})", "/figure/quantity"},
        {R"({"kind": "components", "stacked": 1})", "/figure/stacked"},
        {R"([{"kind": "drift"}, {"kind": "drift"}])", "/figure/1"}};
    for (const auto& [figure, pointer] : cases) {
        INFO(figure);
        const std::string issue = first_issue(figure);
        if (*pointer != '\0') { CHECK(issue.substr(0, issue.find(": ")) == pointer); }
    }
}

TEST_CASE("labels are quoted for gnuplot and escaped for enhanced text") {
    CHECK(gnuplot_quoted("it's `date`") == "'it\\U+0027{}s `date`'");
    CHECK(enhanced_escape("a]]>b") == "a]]{}>b");
    CHECK(enhanced_width("a]]{}>b") == 5);
    CHECK(enhanced_escape("U+1 \\U+2603") == "U+1 \\\\{}U+2603");
    CHECK(enhanced_width("\\\\{}U+2603") == 7);
    CHECK_THROWS_AS(gnuplot_quoted("a\nb"), std::invalid_argument);
    CHECK_THROWS_AS(gnuplot_quoted(std::string("a\0b", 3)), std::invalid_argument);
    CHECK(enhanced_escape("cg4a_x{1}^2@&~\\") == "cg4a\\_x\\{1\\}\\^2\\@\\&\\~\\\\");
    CHECK(enhanced_width("x_{ref} \\_ ω") == 8);
}

TEST_CASE("a slope triangle has the slope it shows, and lies below its curve") {
    for (int p = 1; p <= 6; ++p) {
        std::vector<Point> window;
        for (int k = 4; k < 9; ++k) { window.push_back({std::pow(2.0, -k), std::pow(2.0, -k * p)}); }
        const SlopeTriangle triangle = slope_triangle(window, p);
        REQUIRE(triangle.outline.size() == 4);
        const Point a = triangle.outline[0], c = triangle.outline[2];
        CHECK(std::log(c.y / a.y) / std::log(c.x / a.x) == Approx(p));
        for (const Point& corner : triangle.outline) { CHECK(corner.y < std::pow(corner.x, p)); }
        CHECK(triangle.order.text == std::to_string(p));
    }
}

TEST_CASE("a drawn top is a rigid picture of the body") {
    const double c = std::cos(0.7), s = std::sin(0.7);
    const std::array<double, 9> R = {c, -s, 0, s, c, 0, 0, 0, 1};
    const Point3 lever = {0.2, 1, -0.3}, x = {1, 2, 3};
    const auto lines = drawn_top(x, R, lever, 0.4);
    const Point3 tip = lines[0][0];
    const double length = std::hypot(0.2, 1, -0.3);
    CHECK(std::hypot(tip[0] - x[0], tip[1] - x[1], tip[2] - x[2]) == Approx(length));
    CHECK(tip[0] == Approx(1 - (c * 0.2 - s * 1)));
    CHECK(tip[1] == Approx(2 - (s * 0.2 + c * 1)));
    for (const Point3& point : lines[1]) {
        CHECK(std::hypot(point[0] - x[0], point[1] - x[1], point[2] - x[2]) == Approx(0.4));
        CHECK(std::hypot(point[0] - tip[0], point[1] - tip[1], point[2] - tip[2]) == Approx(std::hypot(length, 0.4)));
    }
}

TEST_CASE("every kind of figure is drawn, without messages from gnuplot") {
    const ResultFolder folder;
    const auto changes =
        nlohmann::json{{"trajectory", "trajectories/aa.csv"}, {"metrics", {{"defect.position", 1e-6}}}};
    folder.write("results.jsonl", convergence_lines(4) + result_line("aa", 100, 1e-4, changes).dump() + "\n");
    folder.write("trajectories/aa.csv", trajectory_text());
    folder.manifest(
        {{"name", "all"},
         {"kind", "trajectory"},
         {"figure",
          {{{"kind", "path3d"}, {"name", "path"}},
           {{"kind", "motion"}, {"name", "motion"}, {"instants", 4}, {"title", "It's a_title"}},
           {{"kind", "components"}, {"name", "omega"}, {"quantity", "omega"}, {"stacked", true}, {"columns", 1}},
           {{"kind", "convergence"}, {"name", "convergence"}, {"facet", "formulation"}, {"title", "T"}},
           {{"kind", "drift"}, {"name", "drift"}, {"metric", "defect.position"}},
           {{"kind", "invariants"}, {"name", "energy"}, {"relative", true}}}}});
    CHECK(plot_command({.folders = {folder.path()}, .figure = {}, .output = {}}) == drawn);
    for (const std::string name : {"path", "motion", "omega", "convergence", "drift", "energy"}) {
        check_drawn(folder, name);
        CHECK(folder.read("plotdata/" + name + ".gp").starts_with(Settings().text()));  // it may be drawn again
    }
    CHECK(folder.read("plotdata/drift.gp").find("∝ t^{2.00 ± 0.00}") != std::string::npos);
    CHECK(folder.read("plotdata/convergence.gp").find("rkmk/rk4: 4.00 ± 0.00") != std::string::npos);
}

TEST_CASE("nothing in a label is executed") {
    const ResultFolder folder;
    const auto mark = (folder.path() / "executed").string();
    const std::vector<std::string> payloads = {"`touch " + mark + "`",
                                               "' ; system('touch " + mark + "') ; '",
                                               "\" ; !touch " + mark + " ; \"",
                                               "$(touch " + mark + ")",
                                               "'.system('touch " + mark + "').'",
                                               "@mark",
                                               "<touch " + mark,
                                               "|touch " + mark,
                                               "{/:`touch " + mark + "`}",
                                               "\\`touch " + mark + "\\`",
                                               "a'\"b",
                                               "#",
                                               "%s%n",
                                               "{",
                                               "}{",
                                               "^_^",
                                               "~&@"};
    std::string lines;
    int first = 0;
    for (const std::string& payload : payloads) { lines += convergence_lines(3, {{"label", payload}}, first += 16); }
    folder.write("results.jsonl", lines);
    folder.manifest({{"name", "labels"},
                     {"kind", "convergence"},
                     {"figure", {{"kind", "convergence"}, {"title", "`touch " + mark + "`"}}}});
    CHECK(plot_command({.folders = {folder.path()}, .figure = {}, .output = {}}) == drawn);
    check_drawn(folder, "labels");
    CHECK(!std::filesystem::exists(mark));
}

TEST_CASE("a figure that cannot be drawn says so, and the others are drawn") {
    const ResultFolder folder;
    folder.write("results.jsonl", convergence_lines(4));
    folder.manifest(
        {{"name", "some"},
         {"kind", "convergence"},
         {"figure", {{{"kind", "path3d"}, {"name", "none"}}, {{"kind", "convergence"}, {"name", "good"}}}}});
    CHECK(plot_command({.folders = {folder.path()}, .figure = {}, .output = {}}) == not_drawn);
    CHECK(!folder.has("figures/none.pdf"));
    check_drawn(folder, "good");
}

TEST_CASE("an experiment without a figure gets the one of its kind") {
    const ResultFolder folder;
    folder.write("results.jsonl", convergence_lines(2));
    folder.manifest({{"name", "plain"}, {"kind", "convergence"}});
    CHECK(plot_command({.folders = {folder.path()}, .figure = {}, .output = {}}) == drawn);
    check_drawn(folder, "plain");
}

TEST_CASE("drift without constraints is shown by the first integrals, and says so where there are none") {
    const nlohmann::json sampled = {{"trajectory", "trajectories/aa.csv"}};
    const auto kind_of = [&](const nlohmann::json& metrics) {
        const ResultFolder folder;
        nlohmann::json line = result_line("aa", 64, 1e-3, sampled);
        line["metrics"] = metrics;
        folder.write("results.jsonl", line.dump() + "\n");
        folder.manifest({{"name", "free"}, {"kind", "drift"}});
        const auto figures = figures_of(read_results(folder.path()));
        REQUIRE(figures.size() == 1);
        CHECK(figures.front()->name == "free");
        return std::pair(figures.front()->kind, figures.front()->drawn_metrics());
    };
    using Metrics = std::vector<std::string>;
    CHECK(kind_of({{"defect.orthogonality", 1e-15},
                   {"invariant.energy", 1e-3},
                   {"invariant.energy.final", 1e-4},
                   {"invariant.momentum_x", 0},
                   {"invariant.spin", 2e-3}}) ==
          std::pair<std::string, Metrics>("invariants", {"invariant.energy", "invariant.spin"}));
    CHECK(kind_of({{"defect.position", 1e-9}, {"invariant.energy", 1e-3}}).first == "drift");
    CHECK(kind_of({{"defect.orthogonality", 1e-15}, {"invariant.momentum_x", 0}}).first == "drift");
}
