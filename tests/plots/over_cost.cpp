// SPDX-License-Identifier: BSD-3-Clause
//
// Figures over time, drawn over what the time has cost.
#include <catch2/catch.hpp>

#include "plots/laws/abscissa.hpp"
#include "records/reading/read_results.hpp"
#include "tests/plots/drawn.hpp"
#include "tests/plots/folder.hpp"

using namespace kreisel;
using namespace kreisel::test;

namespace {

/// Samples at t = 0, 1, 2, 4 with a defect of 1e-3 t^2; the steps slow down.
const std::string counted_samples =
    "t [s],top.x1 [m],top.x2 [m],top.x3 [m],defect.position [m],defect.position.max [m],invariant.energy [J],"
    "invariant.energy.max [J],cost.evaluations [1],cost.accepted [1]\n"
    "0,0,0,0,0,0,0,0,0,0\n1,1,0,0,1e-3,1e-3,1e-3,1e-3,40,10\n2,2,0,0,4e-3,4e-3,2e-3,2e-3,60,15\n"
    "4,4,0,0,16e-3,16e-3,4e-3,4e-3,80,20\n";

Results sampled_results(const ResultFolder& folder, const std::string& samples) {
    folder.write("trajectories/aa.csv", samples);
    const nlohmann::json more = {{"trajectory", "trajectories/aa.csv"}, {"metrics", {{"invariant.energy", 4e-3}}}};
    folder.write("results.jsonl", result_line("aa", 20, 0, more).dump() + "\n");
    Results results = read_results(folder.path());
    results.rows.at(0).cost["run_s"] = 2e-3;
    return results;
}

}  // namespace

TEST_CASE("a figure over time can be drawn over solves, steps or CPU time") {
    const ResultFolder folder;
    const Results results = sampled_results(folder, counted_samples);
    const auto drawn = [&](const char* kind, const char* x, const char* metric = "") {
        nlohmann::json figure = {{"kind", kind}, {"x", x}};
        if (*metric != '\0') { figure["metric"] = metric; }
        return panels_of(figure, results).panels.at(0);
    };
    const auto end = [](const Panel& panel) { return panel.curves.at(0).points.at(3); };
    CHECK(end(drawn("drift", "t", "defect.position")).x == 4);
    CHECK(end(drawn("drift", "evaluations", "defect.position")).x == 80);
    CHECK(end(drawn("drift", "accepted", "defect.position")).x == 20);
    CHECK(end(drawn("drift", "cpu", "defect.position")).x == Approx(2e-3));
    CHECK(drawn("drift", "cpu", "defect.position").curves[0].points[1].x == Approx(1e-3));  // half of the solves
    CHECK(drawn("drift", "cpu", "defect.position").x_label == "CPU time [s]");
    CHECK(end(drawn("drift", "evaluations", "defect.position")).y == 16e-3);
    CHECK(end(drawn("invariants", "evaluations", "invariant.energy")).x == 80);
    CHECK(drawn("invariants", "evaluations").x_label == "solves of the dynamics");
    CHECK(end(drawn("components", "cpu")).x == Approx(2e-3));
    CHECK(drawn("components", "cpu").x_label == "CPU time [s]");
}

TEST_CASE("CPU time is shared out by steps where there are no solves, and of a part of the samples") {
    const ResultFolder folder;
    std::string unsolved = counted_samples;
    for (const char* count : {",40,", ",60,", ",80,"}) { unsolved.replace(unsolved.find(count), 4, ",0,"); }
    const Results results = sampled_results(folder, unsolved);
    const nlohmann::json figure = {{"kind", "components"}, {"x", "cpu"}, {"until", 2}};
    const auto points = panels_of(figure, results).panels.at(0).curves.at(0).points;
    REQUIRE(points.size() == 3);
    CHECK(points[1].x == Approx(1e-3));
    CHECK(points[2].x == Approx(1.5e-3));
}

TEST_CASE("samples that do not tell their cost cannot be drawn over it") {
    const ResultFolder folder;
    const Results results = sampled_results(folder, trajectory_text());
    for (const char* kind : {"drift", "invariants", "components"}) {
        const nlohmann::json figure = {{"kind", kind}, {"x", "evaluations"}};
        CHECK_THROWS_AS(panels_of(figure, results), FigureError);
        CHECK_NOTHROW(panels_of({{"kind", kind}}, results));
    }
    Results untimed = sampled_results(folder, counted_samples);
    untimed.rows.at(0).cost.erase("run_s");
    CHECK_THROWS_AS(panels_of({{"kind", "drift"}, {"x", "cpu"}}, untimed), FigureError);
}
