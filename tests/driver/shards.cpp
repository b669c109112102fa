// SPDX-License-Identifier: BSD-3-Clause
//
// How cells are dealt to the parts of a run, and which parts fit together.
#include <algorithm>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <numeric>
#include <set>
#include <sstream>

#include "driver/plan/shards.hpp"
#include "records/journal.hpp"
#include "records/json/diagnostics.hpp"
#include "records/json/strict.hpp"
#include "records/manifest.hpp"
#include "support/files.hpp"
#include "tests/driver/command_line.hpp"

using namespace kreisel;

namespace {

/// 48 cells, the dearest some 10,000 times as dear as the cheapest; two references.
const std::string uneven = R"({"name": "uneven", "kind": "convergence", "precision": ["double", "quad"],
    "problems": ["heavy_top", "double_pendulum"], "methods": ["rkmk/rk4", "rkmk/midpoint"],
    "projections": ["none", "position_velocity"], "time": {"end": 1, "steps": [2, 16, 256]}})";

Plan plan_read(const std::string& text) { return plan_of(parse_document("t", text), one_engine); }

std::string told(const std::filesystem::path& manifest) { return read_manifest(manifest).state.plan; }

/// As a version has written it that knew no digests.
void make_older(const std::filesystem::path& manifest) {
    auto json = nlohmann::ordered_json::parse(contents(manifest));
    REQUIRE(json.erase("plan") == 1);
    write_summed(manifest, json);
}

/// The cells of a journal.
std::set<std::string> cells_in(const std::filesystem::path& journal) {
    std::istringstream lines(contents(journal));
    std::set<std::string> cells;
    for (std::string line; std::getline(lines, line);) { cells.insert(nlohmann::json::parse(line)["cell"]); }
    return cells;
}

std::set<std::string> cells_dealt(const Plan& plan, std::size_t shard, std::size_t shards) {
    std::set<std::string> cells;
    for (const std::size_t i : cells_of_shard(plan, shard, shards)) { cells.insert(plan.cells[i].hash()); }
    return cells;
}

/// With the references that their cells need.
std::vector<double> costs_of_parts(const Plan& plan, std::size_t shards) {
    std::vector<double> costs;
    for (std::size_t shard = 1; shard <= shards; ++shard) {
        std::set<std::string> references;
        double cost = 0;
        for (const std::size_t i : cells_of_shard(plan, shard, shards)) {
            const PlannedCell& planned = plan.cells[i];
            cost += planned.weight;
            if (references.insert(planned.reference()).second) {
                cost += plan.references.at(planned.reference()).weight;
            }
        }
        costs.push_back(cost);
    }
    return costs;
}

/// Runs a config as a part.
ProgramResult run_part(const std::string& config, const std::filesystem::path& folder, const std::string& shard,
                       std::vector<std::string> words = {}) {
    words.insert(words.begin(), {"run", config, "-o", folder.string(), "--shard", shard});
    return run_program(words);
}

}  // namespace

TEST_CASE("every cell is in one part, whatever their number") {
    const Plan plan = plan_read(uneven);
    REQUIRE(plan.cells.size() == 48);
    for (const std::size_t shards : {1U, 2U, 3U, 5U, 47U, 48U, 49U, 1000U}) {
        INFO(shards);
        std::vector<std::size_t> all;
        for (std::size_t shard = 1; shard <= shards; ++shard) {
            const auto cells = cells_of_shard(plan, shard, shards);
            CHECK(std::is_sorted(cells.begin(), cells.end()));
            all.insert(all.end(), cells.begin(), cells.end());
        }
        std::sort(all.begin(), all.end());
        std::vector<std::size_t> each(plan.cells.size());
        std::iota(each.begin(), each.end(), std::size_t{0});
        CHECK(all == each);
    }
}

TEST_CASE("parts cost alike, the more so the less references cost") {
    Plan plan = plan_read(uneven);
    const auto slowest_over_mean = [&](std::size_t shards) {
        const std::vector<double> costs = costs_of_parts(plan, shards);
        const double mean = std::accumulate(costs.begin(), costs.end(), 0.0) / static_cast<double>(shards);
        return *std::max_element(costs.begin(), costs.end()) / mean;
    };
    for (std::size_t shards = 2; shards <= 5; ++shards) { CHECK(slowest_over_mean(shards) <= 1.5); }
    for (auto& [hash, reference] : plan.references) { reference.weight = 0; }
    for (std::size_t shards = 2; shards <= 5; ++shards) { CHECK(slowest_over_mean(shards) <= 1.15); }
}

TEST_CASE("cells of equal cost go round in the order of the plan") {
    Plan plan = plan_read(R"({"name": "n", "kind": "drift", "problems": ["heavy_top"], "methods": ["rkmk/rk4"],
        "time": {"end": 1, "steps": {"from": 1, "levels": 12}}})");
    for (PlannedCell& planned : plan.cells) { planned.weight = 0.125; }
    for (std::size_t shard = 1; shard <= 5; ++shard) {
        const auto cells = cells_of_shard(plan, shard, 5);
        CHECK(cells.size() >= 2);
        for (const std::size_t i : cells) { CHECK(i % 5 + 1 == shard); }
    }
}

TEST_CASE("a dear reference is computed in as few parts as keep them even") {
    Plan plan = plan_read(uneven);
    REQUIRE(plan.references.size() == 2);
    for (auto& [hash, reference] : plan.references) { reference.weight = 1000 * plan.cells.back().weight; }
    for (const std::size_t shard : {1U, 2U}) {
        const auto cells = cells_of_shard(plan, shard, 2);
        CHECK(cells.size() == plan.cells.size() / 2);
        for (const std::size_t i : cells) { CHECK(plan.cells[i].reference() == plan.cells[cells.front()].reference()); }
    }
}

TEST_CASE("a cell costs more in quad, with more steps, to a smaller tolerance, and next to nothing if skipped") {
    const auto cost = [](const std::string& rest) {
        const Plan plan = plan_read(R"({"name": "n", "kind": "drift", )" + rest + "}");
        REQUIRE(plan.cells.size() == 1);
        return plan.cells.front().weight;
    };
    const std::string top = R"("problems": ["heavy_top"], "methods": ["fake/pair"], )";
    const double plain = cost(top + R"("time": {"end": 1, "steps": 1000})");
    CHECK(cost(top + R"("time": {"end": 1, "steps": 4000})") > 3.5 * plain);
    CHECK(cost(top + R"("precision": "quad", "time": {"end": 1, "steps": 1000})") > 50 * plain);
    const double loose = cost(top + R"("time": {"end": 1, "tolerance": 1e-4})");
    const double tight = cost(top + R"("time": {"end": 1, "tolerance": 1e-8})");
    CHECK(tight - 2e-4 == Approx(10 * (loose - 2e-4)).epsilon(0.15));  // order 4
    CHECK(cost(R"("problems": ["heavy_top"], "methods": ["fake/own"], "time": {"end": 1, "steps": 1000})") < plain);
}

TEST_CASE("parts of any number, run in any order by any number of workers, make the results of one run") {
    const ScratchFolder scratch;
    const std::string config = scratch.file("uneven.json", uneven);
    const Plan plan = plan_read(uneven);
    REQUIRE(run_program({"run", config, "-o", (scratch / "one").string()}).code == 0);
    for (std::size_t shards = 1; shards <= 5; ++shards) {
        INFO(shards);
        const auto merged = scratch / ("merged" + std::to_string(shards));
        std::vector<std::string> words = {"merge", "-o", merged.string()};
        for (std::size_t shard = shards; shard >= 1; --shard) {
            const std::string name = std::to_string(shard) + "-of-" + std::to_string(shards);
            const auto folder = scratch / name;
            const std::string workers = std::to_string(shard % 3 + 1);
            REQUIRE(
                run_part(config, folder, std::to_string(shard) + "/" + std::to_string(shards), {"-j", workers}).code ==
                0);
            CHECK(cells_in(journal_file(folder, shards > 1 ? name : "")) == cells_dealt(plan, shard, shards));
            words.push_back(folder.string());
        }
        CHECK(run_program(words).code == 0);
        for (const char* file : {"results.jsonl", "results.csv"}) {
            CHECK(contents(merged / file) == contents(scratch / "one" / file));
        }
    }
}

TEST_CASE("the digest of a plan knows cells, their order and the number of parts, and no labels") {
    const auto digest = [](const std::string& problems, std::size_t shards) {
        return plan_digest(plan_read(R"({"name": "n", "kind": "drift", "problems": )" + problems +
                                     R"(, "methods": ["rkmk/rk4"], "time": {"end": 1, "steps": [4, 2]}})"),
                           shards);
    };
    const std::string both = digest(R"(["heavy_top", "double_pendulum"])", 2);
    CHECK(both.size() == 16);
    CHECK(digest(R"(["heavy_top", "double_pendulum"])", 2) == both);
    CHECK(digest(R"([{"name": "heavy_top", "label": "top"}, "double_pendulum"])", 2) == both);
    CHECK(digest(R"(["double_pendulum", "heavy_top"])", 2) != both);
    CHECK(digest(R"(["heavy_top"])", 2) != both);
    CHECK(digest(R"(["heavy_top", "double_pendulum"])", 3) != both);
}

TEST_CASE("merge refuses a part of another plan, and names both") {
    const ScratchFolder scratch;
    const std::string config = scratch.file("good.json", good_config());
    const auto a = scratch / "a", b = scratch / "b";
    REQUIRE(run_part(config, a, "1/2").code == 0);
    SECTION("of another number of parts") { REQUIRE(run_part(config, b, "2/3").code == 0); }
    SECTION("of another config") { REQUIRE(run_part(config, b, "2/3", {"--set", "/time/end=2"}).code == 0); }
    const std::string of_a = told(manifest_file(a, "1-of-2")), of_b = told(manifest_file(b, "2-of-3"));
    CHECK(of_a != of_b);
    const auto result = run_program({"merge", a.string(), b.string(), "-o", (scratch / "ab").string()});
    CHECK(result.code == 2);
    CHECK_THAT(result.messages, Catch::Contains(b.string() + ": expected a part of the plan " + of_a + " (" +
                                                a.string() + "), got one of the plan " + of_b));
    CHECK_FALSE(std::filesystem::exists(scratch / "ab"));
}

TEST_CASE("a folder takes parts of one plan only, unless they are overwritten") {
    const ScratchFolder scratch;
    const std::string config = scratch.file("good.json", good_config());
    const auto folder = scratch / "out";
    REQUIRE(run_part(config, folder, "1/2").code == 0);
    const std::string digest = told(manifest_file(folder, "1-of-2"));
    const auto before = contents(manifest_file(folder, "1-of-2"));
    const std::vector<std::string> other = {"--set", "/time/end=2"};
    for (const auto& [shard, words] : std::vector<std::pair<std::string, std::vector<std::string>>>{
             {"2/3", {}}, {"2/2", other}, {"1/2", {"--resume", other[0], other[1]}}}) {
        const auto result = run_part(config, folder, shard, words);
        CHECK(result.code == 2);
        CHECK_THAT(result.messages, Catch::Contains(folder.string() + ": expected a part of the plan "));
        CHECK_THAT(result.messages, Catch::Contains("(this run), got one of the plan " + digest));
    }
    CHECK(contents(manifest_file(folder, "1-of-2")) == before);
    CHECK(run_part(config, folder, "1/2", {"--resume"}).code == 0);
    CHECK(run_part(config, folder, "2/2").code == 0);
    CHECK(run_part(config, folder, "1/2", {"--overwrite", other[0], other[1]}).code == 0);
    CHECK(told(manifest_file(folder, "1-of-2")) != digest);
}

TEST_CASE("whole runs tell no digest, and merge with parts of theirs") {
    const ScratchFolder scratch;
    const std::string config = scratch.file("good.json", good_config());
    const auto whole = scratch / "whole", part = scratch / "part";
    REQUIRE(run_program({"run", config, "-o", whole.string()}).code == 0);
    REQUIRE(run_part(config, part, "1/2").code == 0);
    CHECK(told(manifest_file(whole, "")).empty());
    CHECK(run_program({"merge", whole.string(), part.string()}).code == 0);
    CHECK(run_program({"merge", whole.string(), part.string()}).code == 0);
}

TEST_CASE("parts of older versions, without a digest, are taken with one warning") {
    const ScratchFolder scratch;
    const std::string config = scratch.file("good.json", good_config());
    const auto a = scratch / "a", b = scratch / "b";
    for (const auto& [folder, shard] : {std::pair{a, "1"}, std::pair{b, "2"}}) {
        REQUIRE(run_part(config, folder, std::string(shard) + "/2").code == 0);
        make_older(manifest_file(folder, std::string(shard) + "-of-2"));
    }
    const std::string warning = "manifest.1-of-2.json: warning: written by an older version, without the digest";
    const auto merged = run_program({"merge", a.string(), b.string(), "-o", (scratch / "ab").string()});
    CHECK(merged.code == 0);
    CHECK_THAT(merged.messages, Catch::Contains(warning));
    CHECK(merged.messages.find("older version") == merged.messages.rfind("older version"));
    const auto resumed = run_part(config, a, "1/2", {"--resume"});
    CHECK(resumed.code == 0);
    CHECK_THAT(resumed.messages, Catch::Contains(warning));
    CHECK(told(manifest_file(a, "1-of-2")).size() == 16);
}
