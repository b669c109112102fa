// SPDX-License-Identifier: BSD-3-Clause
//
// Which cells of two folders match, and what counts as a difference.
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "records/diff/compare_cells.hpp"
#include "records/diff/match_cells.hpp"

using namespace kreisel;
using nlohmann::json;

namespace {

/// A result line with a position of 1 m, an error near round-off and one well above it; `changes` are merged into it.
json recorded_line(const json& changes = json::object()) {
    json line = json::parse(R"({"cell": "1f", "problem": "heavy_top", "label": "slow", "parameters": {"mass": 15},
        "formulation": "SE3", "method": "rkmk/rk4", "options": {"coordinates": "exp"}, "projection": "none",
        "projection_options": {}, "precision": "double", "steps": 100, "h": 0.01, "t_end": 1, "status": "ok",
        "final": {"t": 1, "bodies": [{"name": "top", "x": [1, 1e-9, 0], "R": [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
          "v": [0, 2, 0], "omega": [0, 0, 5]}], "multipliers": [100, 3],
          "multiplier_names": ["lambda.pin.1 [N]", "lambda.pin.2 [N m]"],
          "reactions": [{"joint": "pin", "force": [1, 2, 3], "torque": [0, 0, 0], "unique": true}]},
        "metrics": {"error.position": 1e-15, "defect.velocity": 1e-4, "invariant.energy": 1e-6,
          "invariant.energy.relative": 1e-8, "invariant.energy.slope": 2e-6, "invariant.spin": 1e-15},
        "reference": {"error": {"error.position": 1e-30}, "horizon": 10},
        "cost": {"evaluations": 400, "projection_iterations": 0, "cpu_s": 0.5, "step_s": 1e-6, "memory": 4096}})");
    line.merge_patch(changes);
    return line;
}

RecordedCell recorded(const json& changes = json::object()) {
    return read_recorded_cell(recorded_line(changes).dump());
}

/// `recorded_line` with the value at `pointer` replaced.
RecordedCell recorded_with(const std::string& pointer, const json& value) {
    json line = recorded_line();
    line.at(json::json_pointer(pointer)) = value;
    return read_recorded_cell(line.dump());
}

std::vector<QuantityDifference> differences(const RecordedCell& a, const RecordedCell& b,
                                            std::optional<double> within = std::nullopt) {
    const std::vector<RecordedCell> of_a = {a}, of_b = {b};
    const CellComparison comparison = compare_cells(of_a, of_b, within);
    REQUIRE(comparison.only_a.empty());
    REQUIRE(comparison.only_b.empty());
    return comparison.changed.empty() ? std::vector<QuantityDifference>() : comparison.changed.front().quantities;
}

}  // namespace

TEST_CASE("every number of a line that moves by an ulp is detected and named") {
    const json flat = recorded_line().flatten();
    std::size_t numbers = 0;
    for (const auto& [pointer, value] : flat.items()) {
        const bool of_results = pointer.starts_with("/final/") || pointer.starts_with("/metrics/") ||
                                pointer.starts_with("/reference/") || pointer == "/cost/evaluations" ||
                                pointer == "/cost/projection_iterations";
        if (!of_results || !value.is_number()) { continue; }
        INFO(pointer);
        ++numbers;
        const auto found = differences(recorded(), recorded_with(pointer, std::nextafter(value.get<double>(), 1e9)));
        REQUIRE(found.size() == 1);
        CHECK(found.front().ulps == 1);
    }
    CHECK(numbers == 18 + 1 + 2 + 6 + 6 + 2 + 2);
}

TEST_CASE("times, label, hash and step size text are not differences") {
    CHECK(differences(recorded(), recorded({{"cost", {{"cpu_s", 7}, {"step_s", 1}, {"memory", 1}}}})).empty());
    CHECK(differences(recorded(), recorded({{"cell", "2e"}, {"label", "fast"}, {"steps", 100.0}})).empty());
    CHECK(differences(recorded(), recorded({{"invented", {{"member", 1}}}})).empty());
}

TEST_CASE("a number that one side lacks is a difference") {
    const auto found = differences(recorded(), recorded({{"metrics", {{"error.position", nullptr}}}}));
    REQUIRE(found.size() == 1);
    CHECK(found.front().name == "error.position");
    CHECK(found.front().a == "1e-15");
    CHECK(found.front().b.empty());
    CHECK(differences(recorded({{"final", {{"reactions", nullptr}}}}), recorded()).size() == 6);
}

TEST_CASE(
    "within a tolerance, numbers that no cell of one side has are noted; numbers that some lack are a difference") {
    const RecordedCell with = recorded(), without_it = recorded({{"metrics", {{"invariant.spin", nullptr}}}}),
                       other = recorded({{"steps", 200}});
    const std::vector<RecordedCell> a = {without_it}, b = {with};
    const CellComparison one = compare_cells(a, b, 1.0);
    CHECK_FALSE(one.differs());
    CHECK(one.notes == std::vector<std::string>{"invariant.spin is not compared: no cell of A has it"});
    CHECK(compare_cells(b, a, 1.0).notes.size() == 1);
    CHECK(compare_cells(a, b, std::nullopt).differs());
    const std::vector<RecordedCell> some_of_a = {without_it, other}, all_of_b = {with, other};
    CHECK(compare_cells(some_of_a, all_of_b, 1.0).differs());
}

TEST_CASE("samples are compared by their check sum") {
    CHECK(differences(recorded({{"trajectory_sum", "a"}}), recorded({{"trajectory_sum", "b"}})).size() == 1);
    CHECK(differences(recorded({{"trajectory_sum", "a"}}), recorded()).size() == 1);
    CHECK(differences(recorded({{"trajectory_sum", "a"}}), recorded({{"trajectory_sum", "a"}})).empty());
}

TEST_CASE("within a tolerance, the scale is that of the quantity in the cell") {
    const auto moved = [](const std::string& pointer, double value, double within) {
        return !differences(recorded(), recorded_with(pointer, value), within).empty();
    };
    CHECK_FALSE(moved("/final/bodies/0/x/1", 2e-9, 1e-8));  // of 1 m
    CHECK(moved("/final/bodies/0/x/1", 2e-9, 1e-10));
    CHECK_FALSE(moved("/final/bodies/0/v/0", 1e-9, 1e-9));  // of 2 m/s
    CHECK(moved("/final/bodies/0/v/0", 3e-9, 1e-9));
    CHECK_FALSE(moved("/final/multipliers/1", 3 + 2e-9, 1e-9));   // of 3 N m
    CHECK(moved("/final/multipliers/1", 3 + 4e-9, 1e-9));         // and not of the force of 100 N
    CHECK_FALSE(moved("/metrics/error.position", 9e-15, 1e-13));  // of 1 m: round-off
    CHECK(moved("/metrics/error.position", 9e-13, 1e-13));
    CHECK(moved("/metrics/error.position", 1e3, 0.9));                 // of itself where that is larger
    CHECK_FALSE(moved("/metrics/defect.velocity", 1.00001e-4, 1e-9));  // of 2 m/s
    CHECK_FALSE(moved("/metrics/invariant.energy", 2e-6, 1e-7));       // of I0 = 100 J
    CHECK(moved("/metrics/invariant.energy", 2e-6, 1e-9));
    CHECK(moved("/metrics/invariant.spin", 1.1e-15, 1e-3));  // no known scale
    CHECK_FALSE(moved("/cost/evaluations", 401, 1e-9));      // counts are ignored
    CHECK_FALSE(moved("/reference/horizon", 11, 1e-9));
}

TEST_CASE("a changed status is reported, and nothing else of that cell") {
    const std::vector<RecordedCell> a = {recorded()},
                                    b = {recorded({{"status", "newton_failed"}, {"metrics", nullptr}})};
    const CellComparison comparison = compare_cells(a, b, 1.0);
    REQUIRE(comparison.changed.size() == 1);
    CHECK(comparison.changed.front().status_changed());
    CHECK(comparison.changed.front().quantities.empty());
    CHECK(comparison.differs());
}

TEST_CASE("cells are matched by what was run, whatever their order") {
    const std::vector<RecordedCell> a = {recorded({{"steps", 100}}), recorded({{"steps", 200}}),
                                         recorded({{"options", {{"coordinates", "cayley"}}}})},
                                    b = {a[1], recorded({{"parameters", {{"mass", 16}}}}), a[0]};
    const CellMatching matching = match_cells(a, b);
    CHECK(matching.pairs == std::vector<std::pair<std::size_t, std::size_t>>{{0, 2}, {1, 0}});
    CHECK(matching.only_a == std::vector<std::size_t>{2});
    CHECK(matching.only_b == std::vector<std::size_t>{1});
    CHECK(matching.notes.empty());
}

TEST_CASE("of cells with equal runs those with equal labels match") {
    const std::vector<RecordedCell> a = {recorded({{"label", "one"}}), recorded({{"label", "two"}})},
                                    b = {a[1], recorded({{"label", "three"}})};
    const CellMatching matching = match_cells(a, b);
    CHECK(matching.pairs == std::vector<std::pair<std::size_t, std::size_t>>{{0, 1}, {1, 0}});
}

TEST_CASE("an option that only one version has is ignored if only one cell qualifies") {
    const RecordedCell plain = recorded(), exact = recorded({{"options", {{"dexpinv", "exact"}}}}),
                       seed = recorded({{"options", {{"dexpinv", "seed"}}}});
    const CellMatching one = match_cells({plain}, {exact});
    CHECK(one.pairs.size() == 1);
    REQUIRE(one.notes.size() == 1);
    CHECK(one.notes.front() == "1 cell is matched although only B tells options.dexpinv");
    CHECK(match_cells({exact}, {plain}).notes.front() == "1 cell is matched although only A tells options.dexpinv");
    CHECK(match_cells({plain}, {exact, seed}).pairs.empty());
    CHECK(match_cells({seed}, {exact}).pairs.empty());
    const RecordedCell heavier = recorded({{"options", nullptr}, {"parameters", {{"lever", 1}}}});
    CHECK(match_cells({plain}, {heavier}).pairs.empty());  // each has a member that the other lacks
}

TEST_CASE("a line of an older version may lack what came later") {
    const RecordedCell cell = read_recorded_cell(
        R"({"cell": "1", "problem": "p", "method": "m", "status": "ok",
            "final": {"bodies": [{"x": [1, 2, 3]}], "multipliers": [4]}})");
    CHECK(cell.label == "p");
    CHECK(cell.final_state.at("final.body1.x.3").number.value == 3);
    CHECK(cell.final_state.at("final.lambda.1").number.value == 4);
    CHECK(cell.metrics.empty());
}

TEST_CASE("lines that are none are refused") {
    for (const char* line : {"", "rubbish", "[]", R"({"cell": "1"})", R"({"cell": "1", "problem": "p", "status": 3})",
                             R"({"cell": "1", "problem": "p", "status": "ok", "metrics": {"error.position": "x"}})"}) {
        INFO(line);
        CHECK_THROWS_AS(read_recorded_cell(line), std::exception);
    }
}
