// SPDX-License-Identifier: BSD-3-Clause
//
// The whole program over the real engines, with steps to tolerances: the same bytes whatever runs beside a cell.
#include <catch2/catch.hpp>
#include <cmath>

#include "plots/laws/proportionality.hpp"
#include "records/reading/read_results.hpp"
#include "records/reading/trajectory_table.hpp"
#include "records/results.hpp"
#include "support/files.hpp"
#include "tests/campaign/program.hpp"

using namespace kreisel;
using namespace kreisel::acceptance;

namespace {

/// Every method with an estimate of its error, whatever it is called.
std::string adaptive_methods() {
    std::string names;
    for (const MethodDescription& method : engine_binary64().methods()) {
        if (method.estimate > 0 || method.own_control) names += (names.empty() ? "\"" : ", \"") + method.name + "\"";
    }
    return names;
}

std::string adaptive_config(const std::string& kind, const std::string& problems, int levels, const std::string& rest) {
    return R"({"name": "adaptive", "kind": ")" + kind + R"(", "problems": [)" + problems + R"(],
        "formulations": ["SO3xR3"], "projections": ["none", "position_velocity"], "methods": [)" +
           adaptive_methods() + R"(], "time": {"end": 0.0625, "tolerance": {"from": 1e-3, "levels": )" +
           std::to_string(levels) + "}}" + rest + "}";
}

}  // namespace

TEST_CASE("adaptive cells are the same bytes for any number of workers, and verified", "[campaign]") {
    REQUIRE_FALSE(adaptive_methods().empty());
    const Folder folder;
    const auto config = folder.file("adaptive.json", adaptive_config("convergence", R"("heavy_top", "double_pendulum")",
                                                                     4, R"(, "output": {"samples": 5})"));
    const std::string one = (folder.path / "one").string(), four = (folder.path / "four").string();
    REQUIRE(kreisel_with({"run", config, "-o", one, "-j", "1"}).code == 0);
    REQUIRE(kreisel_with({"run", config, "-o", four, "-j", "4"}).code == 0);
    for (const char* file : {"results.jsonl", "results.csv"}) {
        CHECK(read_text(folder.path / "one" / file) == read_text(folder.path / "four" / file));
    }
    CHECK(kreisel_with({"verify", four}).code == 0);
    const Results results = read_results(one);
    std::size_t sampled = 0;
    for (const ResultRow& row : results.rows) {
        if (!row.ok()) continue;
        INFO(row.method << row.label << row.projection << row.tolerance);
        CHECK(row.cost.at("accepted") > 0);
        CHECK(row.metrics.at("error.position") < 1);
        CHECK(read_trajectory(row).columns.front().size() == 6);
        ++sampled;
    }
    CHECK(sampled >= 8);
}

TEST_CASE("a cell of a work_precision experiment has its CPU time and counts, and its results none", "[campaign]") {
    const Folder folder;
    // Each cell is timed for a good part of a second, so one of each method has to do.
    const auto config = folder.file(
        "priced.json", adaptive_config("work_precision", R"("heavy_top")", 1, R"(, "metrics": ["error.*"])"));
    const std::string out = (folder.path / "out").string();
    REQUIRE(kreisel_with({"run", config, "-o", out}).code == 0);
    CHECK(read_text(folder.path / "out" / "results.jsonl").find("run_s") == std::string::npos);
    for (const ResultRow& row : read_results(out).rows) {
        if (!row.ok()) continue;
        INFO(row.method << row.label << row.projection << row.tolerance);
        CHECK(row.cost.at("run_s") > 0);
        CHECK(row.cost.at("evaluations") >= row.cost.at("accepted"));
    }
    CHECK(kreisel_with({"table", out}).code == 0);
    CHECK(std::filesystem::exists(folder.path / "out" / "tables" / "work_precision.csv"));
}
