// SPDX-License-Identifier: BSD-3-Clause
//
// Table entries without a number: short reasons, marks, units of any metric.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

#include "plots/table.hpp"
#include "plots/tables/names.hpp"
#include "records/reading/read_results.hpp"
#include "support/hash.hpp"
#include "tests/plots/folder.hpp"
#include "tests/plots/named_tables.hpp"

using namespace kreisel;
using namespace kreisel::test;

namespace {

/// Six lines of a method of this name, with error(h) in one metric.
std::string lines_of(const std::string& method, const std::function<double(double)>& error,
                     nlohmann::json changes = nlohmann::json::object()) {
    std::string text;
    for (int k = 0; k < 6; ++k) {
        const long steps = 64L << k;
        changes["method"] = method;
        const std::string cell = hash_text(changes.dump() + std::to_string(k));
        text += result_line(cell, steps, error(1.0 / static_cast<double>(steps)), changes).dump() + "\n";
    }
    return text;
}

Results results_of(const ResultFolder& folder, const std::string& lines) {
    folder.write("results.jsonl", lines);
    return read_results(folder.path());
}

/// The entry of the row that starts with `first`, under `column`.
std::string entry(const TextTable& table, const std::string& first, const std::string& column) {
    const auto at = std::find(table.columns.begin(), table.columns.end(), column);
    REQUIRE(at != table.columns.end());
    for (const auto& row : table.rows) {
        if (row.at(0) == first) { return row.at(static_cast<std::size_t>(at - table.columns.begin())); }
    }
    return "no row " + first;
}

}  // namespace

TEST_CASE("where no order can be stated the table says why") {
    const ResultFolder folder;
    // The local slopes 0.6, 0.6, 0.42, 0.55, 0.6 agree, are not a plateau, and one is below 1/2.
    const auto slow = [](double h) {
        const std::array<double, 6> falls = {0, 0.6, 1.2, 1.62, 2.17, 2.77};
        return 1e-3 * std::pow(2, -falls.at(static_cast<std::size_t>(std::lround(-std::log2(h))) - 6));
    };
    const Results results = results_of(
        folder, lines_of("good", [](double h) { return h * h; }) + lines_of("large", [](double) { return 0.5; }) +
                    lines_of("exact", [](double) { return 0; }) +
                    lines_of("bent", [](double h) { return 1e-3 * h * (h < 1.0 / 600 ? std::pow(600 * h, 2) : 1); }) +
                    lines_of("flat", [](double h) { return 1e-3 * std::pow(h, 0.1); }) + lines_of("slow", slow) +
                    result_line("aa", 64, 1e-3, {{"method", "short"}}).dump() + "\n");
    const TextTable brief = tables_named("orders", results).at(0).brief();
    CHECK(entry(brief, "good", "position") == "2.00 ± 0.00 [64–2048]");
    CHECK(entry(brief, "large", "position") == "pre-asymptotic");
    CHECK(entry(brief, "exact", "position") == "floor");
    CHECK(entry(brief, "bent", "position") == "not settled");
    CHECK(entry(brief, "flat", "position") == "no convergence");
    CHECK(entry(brief, "slow", "position") == "no convergence");
    CHECK(entry(brief, "short", "position") == "too few points");
    const TextTable full = tables_named("orders", results).at(0).full;
    const auto remark = [&](const std::string& method) {
        for (const auto& row : full.rows) {
            if (row.at(2) == method) { return row.back(); }
        }
        return std::string();
    };
    CHECK(remark("good").empty());
    CHECK(remark("exact") == "no error at all");
    CHECK_THAT(remark("flat"), Catch::StartsWith("the error stops falling at "));
    CHECK(remark("slow") == "no convergence: the finest slopes are 0.42, 0.55, 0.60");
    CHECK_THAT(remark("bent"), Catch::StartsWith("not settled: the finest slopes are "));
    CHECK_THAT(remark("large"), Catch::StartsWith("pre-asymptotic"));
}

TEST_CASE("errors that leap over the admissible range are told apart from those that never enter it") {
    const ResultFolder folder;
    const Results results = results_of(folder, lines_of("leap", [](double h) { return h > 1.0 / 200 ? 0.5 : 1e-17; }));
    CHECK(tables_named("orders", results).at(0).full.rows.at(0).back() ==
          "the errors leap from above 1e-2 of the scale to the floor");
}

TEST_CASE("certification marks what falls short, has not settled, or failed") {
    const ResultFolder folder;
    const auto none = nlohmann::json{{"order", nullptr}};
    const Results results = results_of(
        folder,
        lines_of("good", [](double h) { return std::pow(h, 4); }) +
            lines_of("low", [](double h) { return h * h * h; }) +
            lines_of("bent", [](double h) { return 1e-3 * h * (h < 1.0 / 600 ? std::pow(600 * h, 2) : 1); }) +
            lines_of("flat", [](double h) { return 1e-3 * std::pow(h, 0.1); }) +
            lines_of(
                "silent", [](double h) { return h * h; }, none) +
            lines_of("failed", [](double) { return 1; },
                     {{"status", "left_chart"}, {"detail", "step 1"}, {"metrics", nullptr}, {"final", nullptr}}));
    const auto tables = tables_named("certification", results);
    REQUIRE(tables.size() == 1);
    CHECK(entry(tables[0].brief(), "good", "SO3xR3") == "4.00 / - / -");
    CHECK(entry(tables[0].brief(), "good", "declared") == "4 / 4 / 3");
    CHECK(entry(tables[0].brief(), "low", "SO3xR3") == "3.00! / - / -");
    CHECK(entry(tables[0].brief(), "bent", "SO3xR3") == "? / - / -");
    CHECK(entry(tables[0].brief(), "flat", "SO3xR3") == "! / - / -");
    CHECK(entry(tables[0].brief(), "silent", "SO3xR3") == "2.00 / - / -");
    CHECK(entry(tables[0].brief(), "silent", "declared") == "-");
    CHECK(entry(tables[0].brief(), "failed", "SO3xR3") == "left_chart");
}

TEST_CASE("a method of one order for all has one number, and one that declares none a dash") {
    const ResultFolder folder;
    const nlohmann::json same = {{"order", {{"configuration", 2}, {"velocity", 2}, {"multipliers", 2}}}};
    const Results results =
        results_of(folder, lines_of(
                               "even", [](double h) { return h * h; }, same) +
                               lines_of("uneven", [](double h) { return h * h; }) +
                               lines_of("none", [](double h) { return h * h; }, {{"order", nullptr}}));
    const TextTable brief = tables_named("orders", results).at(0).brief();
    CHECK(entry(brief, "even", "declared") == "2");
    CHECK(entry(brief, "uneven", "declared") == "4, 4, 3");
    CHECK(entry(brief, "none", "declared") == "-");
}

TEST_CASE("a reference without bound, scale or error has no digits to show") {
    const ResultFolder folder;
    const Results results = results_of(
        folder,
        lines_of("m", [](double h) { return h; },
                 {{"reference", {{"error", {{"error.position", 0}, {"error.multipliers", 1e-20}}}, {"horizon", 3}}}}));
    const TextTable table = tables_named("references", results).at(0).full;
    REQUIRE(table.rows.size() == 1);
    CHECK(table.rows[0][0] == "heavy_top");
    CHECK(std::count(table.rows[0].begin(), table.rows[0].end(), "exact") == 1);
    CHECK(std::count(table.rows[0].begin(), table.rows[0].end(), "20.5") == 1);  // |lambda| = 3
    CHECK(std::count(table.rows[0].begin(), table.rows[0].end(), "-") == 3);
}

TEST_CASE("the unit of a metric is that of its description or integral, and follows its suffix") {
    const Units units = units_of_metrics({{"energy", "J", ""},
                                          {"momentum_x", "N s", ""},
                                          {"angular_momentum_vertical", "N m s", ""},
                                          {"area", "m^2", ""},
                                          {"spin", "1/s", ""},
                                          {"spin", "rad/s", ""}});
    const std::pair<const char*, const char*> cases[] = {{"error.rotation", "rad"},
                                                         {"defect.velocity.final", "m/s"},
                                                         {"defect.position.max", "m"},
                                                         {"invariant.energy", "J"},
                                                         {"invariant.energy.max", "J"},
                                                         {"invariant.energy.relative", "1"},
                                                         {"invariant.energy.slope", "W"},
                                                         {"invariant.energy.slope_error", "W"},
                                                         {"invariant.momentum_x", "N s"},
                                                         {"invariant.momentum_x.slope", "N"},
                                                         {"invariant.angular_momentum_vertical", "N m s"},
                                                         {"invariant.angular_momentum_vertical.slope", "N m"},
                                                         {"invariant.area.slope", "m^2/s"},
                                                         {"invariant.spin", ""},
                                                         {"invariant.unheard_of", ""}};
    for (const auto& [metric, unit] : cases) {
        INFO(metric);
        CHECK(metric_unit(metric, units) == unit);
    }
}

TEST_CASE("a drift table gives what was measured, and dashes where there is no growth law") {
    const ResultFolder folder;
    const auto line = [](const std::string& cell, const nlohmann::json& changes) {
        return result_line(cell, 100, 1e-3, changes).dump() + "\n";
    };
    folder.write("trajectories/ab.csv", trajectory_text());
    const Results results = results_of(
        folder, line("aa", {{"method", "a"}, {"metrics", {{"defect.velocity", 2}}}}) +
                    line("ab", {{"method", "b"},
                                {"metrics", {{"defect.position", 1e-6}, {"defect.position.final", 1e-7}}},
                                {"trajectory", "trajectories/ab.csv"}}) +
                    line("ac", {{"method", "c"}, {"status", "skipped"}, {"metrics", {{"defect.velocity", 2}}}}));
    const TextTable table = tables_named("drift", results).at(0).full;
    REQUIRE(table.rows.size() == 2);
    const auto tail = [](const std::vector<std::string>& row) { return std::vector(row.end() - 6, row.end()); };
    CHECK(tail(table.rows[0]) == std::vector<std::string>{"velocity", "2", "", "-", "-", "-"});
    CHECK(tail(table.rows[1])[0] == "position");
    CHECK(tail(table.rows[1])[3] == "2.00");
    CHECK_THAT(tail(table.rows[1])[5], Catch::EndsWith("–1"));
}
