// SPDX-License-Identifier: BSD-3-Clause
//
// From result lines to tables: orders with their windows, failures listed, damage reported.
#include <algorithm>
#include <catch2/catch.hpp>

#include "plots/laws/growth.hpp"
#include "plots/table.hpp"
#include "plots/tables/names.hpp"
#include "records/reading/read_results.hpp"
#include "records/reading/trajectory_table.hpp"
#include "records/remarks/lost_integrals.hpp"
#include "records/remarks/past_horizon.hpp"
#include "support/errors.hpp"
#include "tests/plots/folder.hpp"

using namespace kreisel;
using namespace kreisel::test;

namespace {

constexpr Exit ok = Exit::ok, damaged = Exit::io;

}  // namespace

TEST_CASE("a convergence study becomes a table of orders with windows") {
    const ResultFolder folder;
    folder.write("results.jsonl", convergence_lines(4) + convergence_lines(2, {{"method", "rkmk/midpoint"}}, 16));
    CHECK(table_command(folder.path()) == ok);
    const std::string orders = folder.read("tables/orders.csv");
    CHECK(orders.find("heavy_top,SO3xR3,rkmk/rk4,none,double,error.position,4,4.0000,0.0000,64,1024,least squares") !=
          std::string::npos);
    CHECK(orders.find(
              "heavy_top,SO3xR3,rkmk/midpoint,none,double,error.position,4,2.0000,0.0000,64,2048,least squares") !=
          std::string::npos);
    CHECK(folder.read("tables/orders.tex").find("4.00 $\\pm$ 0.00 [64--1024]") != std::string::npos);
    CHECK(folder.read("tables/errors.csv").find("2048,0.00048828125,5.684341886080802e-14") != std::string::npos);
    CHECK(folder.has("tables/cost.md"));
    // |x| = 1 and a bound of 1e-25; the other quantities have no bound.
    CHECK(folder.read("tables/references.csv").find("heavy_top,1,10,25.0,-,-,-,-") != std::string::npos);
}

TEST_CASE("maxima over samples stand beside the errors of the end in every table") {
    const ResultFolder folder;
    std::string lines;
    for (int k = 0; k < 6; ++k) {
        const long steps = 64L << k;
        const double error = std::pow(1.0 / static_cast<double>(steps), 4);
        const nlohmann::json more = {{"metrics", {{"error.position.max", 3 * error}}},
                                     {"reference", {{"error", {{"error.position.max", 1e-24}}}}}};
        lines += result_line("0" + std::to_string(k), steps, error, more).dump() + "\n";
    }
    folder.write("results.jsonl", lines);
    CHECK(table_command(folder.path()) == ok);
    CHECK(folder.read("tables/orders.csv").find("error.position.max,4,4.0000,0.0000,64,1024") != std::string::npos);
    CHECK(folder.read("tables/errors.csv").find("error.position [m],error.position.max [m]") != std::string::npos);
    CHECK(folder.read("tables/errors.md").find("largest of all samples") != std::string::npos);
    CHECK(folder.read("tables/references.csv").find("heavy_top,1,10,25.0,24.0") != std::string::npos);
}

TEST_CASE("errors past the horizon of their reference are marked in every table") {
    const ResultFolder folder;
    const nlohmann::json past = {
        {"label", "far"},
        {"reference", {{"error", {{"error.position", 1e-20}}}, {"horizon", 0.5}, {"past_horizon", true}}}};
    folder.write("results.jsonl", convergence_lines(4) + convergence_lines(4, past, 16));
    CHECK(table_command(folder.path()) == ok);
    const std::string errors = folder.read("tables/errors.md"), full = folder.read("tables/errors.csv");
    CHECK(errors.find("| far |") != std::string::npos);
    CHECK(errors.find("5.68e-14\\*") != std::string::npos);
    CHECK(errors.find("asterisk marks errors past the horizon") != std::string::npos);
    CHECK(folder.read("tables/errors.tex").find("$5.68\\cdot10^{-14}$*") != std::string::npos);
    CHECK(full.find("5.684341886080802e-14,yes\n") != std::string::npos);
    CHECK(full.find("5.684341886080802e-14,\n") != std::string::npos);
    CHECK(folder.read("tables/references.csv").find("far,1,0.5*,20.0") != std::string::npos);
    const auto notes = past_horizon_notes(read_results(folder.path()).rows);
    REQUIRE(notes.size() == 1);
    CHECK(notes[0] ==
          "far: 6 cells end at 1 s, past the horizon T* = 0.5 s of their reference, which is uncertain by "
          "1.0e-20 m there: only errors above 100 times its uncertainty are measured");
}

TEST_CASE("cells far from a first integral are counted, and the farthest is named") {
    const ResultFolder folder;
    folder.write("results.jsonl", convergence_lines(4));
    CHECK(lost_integral_notes(read_results(folder.path()).rows).empty());
    const auto drifted = [](double share) {
        return nlohmann::json{{"label", "far"}, {"lost", {{"integral", "energy"}, {"share", share}}}};
    };
    folder.write("results.jsonl", convergence_lines(4, {{"label", "far"}}) + convergence_lines(4, drifted(0.02), 16) +
                                      convergence_lines(2, drifted(0.5), 32));
    const auto notes = lost_integral_notes(read_results(folder.path()).rows);
    REQUIRE(notes.size() == 1);
    CHECK_THAT(notes[0],
               Catch::Contains("far: 12 of 18 cells end ok") && Catch::Contains("energy by 50 % at most (rkmk/rk4"));
}

TEST_CASE("declared and observed orders stand side by side, and a shortfall is marked") {
    const ResultFolder folder;
    folder.write("results.jsonl", convergence_lines(4) + convergence_lines(2, {{"formulation", "SE3"}}, 16));
    CHECK(table_command(folder.path()) == ok);
    CHECK(folder.read("tables/certification.csv") ==
          "method,declared,SO3xR3,SE3\nrkmk/rk4,4 / 4 / 3,4.00 / - / -,2.00! / - / -\n");
    folder.write("results.jsonl", convergence_lines(4) + convergence_lines(4, {{"label", "A/b"}}, 16));
    CHECK(table_command(folder.path()) == ok);
    CHECK(folder.has("tables/certification_heavy_top.tex"));
    CHECK(folder.has("tables/certification___b.tex"));
}

TEST_CASE("numbers of quad cells are read from decimal strings") {
    const ResultRow row = read_result_line(
        result_line("aa", 64, 0,
                    {{"precision", "quad"},
                     {"h", "0.015625"},
                     {"metrics",
                      {{"error.position", "1.25e-30"}, {"error.multipliers", "1"}, {"error.multipliers.torque", "1"}}}})
            .dump());
    CHECK(row.metrics.at("error.position") == 1.25e-30);
    CHECK(row.h == 0.015625);
    CHECK(row.scale.at("error.multipliers") == 3);
    CHECK_FALSE(row.scale.contains("error.multipliers.torque"));
}

TEST_CASE("failed and skipped cells are listed with their reason, and enter no order") {
    const ResultFolder folder;
    const auto failed = result_line(
        "ff", 32, 0, {{"status", "singular_kkt"}, {"detail", "step 3"}, {"metrics", nullptr}, {"final", nullptr}});
    const auto skipped = result_line(
        "fe", 32, 0, {{"status", "skipped"}, {"detail", "no | such thing"}, {"metrics", nullptr}, {"final", nullptr}});
    folder.write("results.jsonl", convergence_lines(3) + failed.dump() + "\n" + skipped.dump() + "\n");
    CHECK(table_command(folder.path()) == ok);
    const std::string text = folder.read("tables/not_ok.csv");
    CHECK(text.find("singular_kkt,step 3") != std::string::npos);
    CHECK(text.find("skipped,no | such thing") != std::string::npos);
    CHECK(folder.read("tables/not_ok.md").find("no \\| such thing") != std::string::npos);
    CHECK(folder.read("tables/orders.csv").find(",3.0000,") != std::string::npos);
}

TEST_CASE("a damaged file gives its good lines, and says what is damaged") {
    const std::string good = convergence_lines(4);
    for (const std::string& bad :
         {std::string("{\"cell\": \"0\""), std::string("[]"), std::string("null"), std::string("{}"),
          std::string("\xff\xfe"), std::string(100000, '['), std::string("{\"cell\":\"../x\"}")}) {
        const ResultFolder folder;
        folder.write("results.jsonl", good + bad + "\n");
        const Results results = read_results(folder.path());
        CHECK(results.rows.size() == 6);
        CHECK(results.damage.size() == 1);
        CHECK(results.damage.front().find("results.jsonl:7: ") == 0);
        CHECK(table_command(folder.path()) == damaged);
    }
}

TEST_CASE("a results file cut at any byte never crashes the reader") {
    const std::string good = convergence_lines(4).substr(0, 1400);
    const ResultFolder folder;
    for (std::size_t length = 0; length <= good.size(); length += 7) {
        folder.write("results.jsonl", good.substr(0, length));
        const Results results = read_results(folder.path());
        const std::string kept = good.substr(0, length);
        const auto whole = static_cast<std::size_t>(std::count(kept.begin(), kept.end(), '\n'));
        const bool torn = !kept.empty() && kept.back() != '\n';
        CHECK(results.rows.size() + results.damage.size() == whole + (torn ? 1 : 0));
        CHECK(results.rows.size() >= whole);
    }
}

TEST_CASE("a folder without results is an error of input") {
    const ResultFolder folder;
    CHECK_THROWS_AS(table_command(folder.path()), FileError);
}

TEST_CASE("growth laws come from the running maxima of the trajectory") {
    const ResultFolder folder;
    folder.write(
        "results.jsonl",
        result_line("ab", 100, 1e-3, {{"metrics", {{"defect.position", 1e-6}}}, {"trajectory", "trajectories/ab.csv"}})
                .dump() +
            "\n");
    folder.write("trajectories/ab.csv", trajectory_text());
    const Results results = read_results(folder.path());
    const auto law = growth_of(read_trajectory(results.rows.front()), "defect.position", "double");
    REQUIRE(law);
    CHECK(law->exponent == Approx(2));
    CHECK(law->coefficient == Approx(1e-6));
    CHECK(table_command(folder.path()) == ok);
    CHECK(folder.read("tables/drift.csv").find("position,1e-06,,2.00,0.00,0.26–1") != std::string::npos);
    folder.write("trajectories/ab.csv", trajectory_text().substr(0, 900));
    CHECK_THROWS_AS(table_command(folder.path()), FileError);
}

TEST_CASE("methods are named with the options that vary, and no others") {
    std::vector<ResultRow> rows;
    for (const char* coordinates : {"exp", "cayley"}) {
        rows.push_back(read_result_line(
            result_line("aa", 64, 1, {{"options", {{"coordinates", coordinates}, {"dexpinv", "exact"}}}}).dump()));
    }
    const CellNames names(rows);
    CHECK(names.axis(rows[0], "method") == "rkmk/rk4 exp");
    CHECK(names.axis(rows[1], "method") == "rkmk/rk4 cayley");
    CHECK(names.varying_axes({}) == std::vector<std::string>{"method"});
    CHECK(group_by_method(rows).size() == 2);
}
