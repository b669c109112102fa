// SPDX-License-Identifier: BSD-3-Clause
//
// References are jobs of their own: done once, under a lock, and their bad ends are those of the cells that need them.
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "driver/cli/cli.hpp"
#include "tests/driver/command_line.hpp"
#include "tests/driver/workers/saboteurs.hpp"

using namespace kreisel;

namespace {

std::string of_masses(const nlohmann::json& masses) {
    return nlohmann::json({{"name", "evil"},
                           {"kind", "convergence"},
                           {"problems", {"heavy_top", {{"name", "free_top"}, {"parameters", {{"mass", masses}}}}}},
                           {"methods", {"rkmk/rk4"}},
                           {"time", {{"end", 1}, {"steps", {{"from", 2}, {"levels", 8}}}}}})
        .dump();
}

std::vector<nlohmann::json> recorded_lines(const std::filesystem::path& folder) {
    std::vector<nlohmann::json> lines;
    std::istringstream stream(contents(folder / "results.jsonl"));
    for (std::string line; std::getline(stream, line);) { lines.push_back(nlohmann::json::parse(line)); }
    return lines;
}

std::size_t count_of_files_in(const std::filesystem::path& folder) {
    return static_cast<std::size_t>(
        std::distance(std::filesystem::directory_iterator(folder), std::filesystem::directory_iterator()));
}

}  // namespace

TEST_CASE("a reference that ends badly gives its cells no_reference with the reason, and no other cell anything") {
    const ScratchFolder scratch;
    const Saboteurs engine;
    const char* const reasons[] = {"", "crashed(SIGSEGV)", "timeout", "out_of_memory", "exception"};
    for (const char* jobs : {"1", "2", "4"}) {
        const auto folder = scratch / jobs;
        const auto result = run_program({"run", scratch.file("c.json", of_masses({1, 2, 3, 4, 5})), "-o",
                                         folder.string(), "-j", jobs, "--timeout", "2", "--max-memory", "64MB"},
                                        engine);
        CHECK(result.code == 1);
        CHECK_THAT(result.messages, Catch::Contains("crashed(SIGSEGV): reference of free_top at t = 1 s: its process"));
        const auto lines = recorded_lines(folder);
        REQUIRE(lines.size() == 48);
        for (const auto& line : lines) {
            const int mass = line["problem"] == "free_top" ? line["parameters"]["mass"].get<int>() : 5;
            INFO(mass);
            CHECK(line["status"] == (mass == 5 ? "ok" : std::string("no_reference(") + reasons[mass] + ")"));
            CHECK(line["metrics"].contains("error.position") == (mass == 5));
        }
        CHECK(count_of_files_in(folder / "references") == 2);
        CHECK(contents(folder / "results.jsonl") == contents(scratch / "1" / "results.jsonl"));
    }
}

TEST_CASE("references can be computed by themselves, and cells are then run without computing them again") {
    const ScratchFolder scratch;
    const Saboteurs engine;
    const std::string config = scratch.file("c.json", of_masses({5, 6})), folder = (scratch / "out").string();
    const auto first = run_program({"run", config, "-o", folder, "--references-only"}, engine);
    CHECK(first.code == 0);
    CHECK_THAT(first.messages, Catch::Contains("evil: 3 references, 0 failed in "));
    CHECK(engine.references == 3);
    CHECK(engine.runs == 0);
    CHECK_FALSE(std::filesystem::exists(scratch / "out" / "results.jsonl"));
    CHECK(run_program({"run", config, "-o", folder}, engine).code == 0);
    CHECK(engine.references == 3);
    CHECK(engine.runs == 24);
    const std::string failing = scratch.file("failing.json", of_masses({4, 5}));
    const auto failed = run_program({"run", failing, "-o", (scratch / "failed").string(), "--references-only"}, engine);
    CHECK(failed.code == 1);
    CHECK_THAT(failed.messages, Catch::Contains("failed: exception: reference of free_top at t = 1 s: thrown on"));
    CHECK_THAT(failed.messages, Catch::Contains("evil: 2 references, 1 failed in "));
}

TEST_CASE("runs that share a cache compute a reference once") {
    const ScratchFolder scratch;
    const FakeEngine engine;
    const std::string config = scratch.file("c.json", R"({"name": "one", "kind": "convergence",
        "problems": ["heavy_top"], "methods": ["rkmk/rk4"], "time": {"end": 1001, "steps": 2}})");
    std::vector<pid_t> children;
    for (const char* name : {"a", "b", "c"}) {
        const std::string folder = (scratch / name).string();
        children.push_back(::fork());
        if (children.back() == 0) {
            ::setenv("KREISEL_CACHE", (scratch / "cache").c_str(), 1);
            const char* const words[] = {"kreisel", "run", config.c_str(), "-o", folder.c_str()};
            ::close(STDERR_FILENO);
            ::_exit(kreisel_main(5, words, engine, engine));
        }
    }
    for (const pid_t child : children) {
        int status = 0;
        ::waitpid(child, &status, 0);
        CHECK(status == 0);
    }
    CHECK(engine.references == 1);
    CHECK(contents(scratch / "a" / "results.jsonl") == contents(scratch / "c" / "results.jsonl"));
}
