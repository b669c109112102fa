// SPDX-License-Identifier: BSD-3-Clause
//
// Samples reach the disk while their cell runs: what an interrupted or killed run leaves, and how a run resumes.
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "driver/cli/cli.hpp"
#include "driver/plan/plan.hpp"
#include "records/geometry.hpp"
#include "records/json/strict.hpp"
#include "records/trajectory_file.hpp"
#include "support/errors.hpp"
#include "tests/driver/command_line.hpp"

using namespace kreisel;

namespace {

// A second and a half with 300 samples.
const std::string slow = R"({"name": "slow", "kind": "trajectory", "problems": ["heavy_top"], "methods": ["fake/slow"],
    "time": {"end": 1, "steps": 1500}, "output": {"samples": 300}})";

struct Stopped {
    int status;
    std::string messages;
};

// Starts the program in a process of its own and sends it a signal as soon as there are samples on disk.
Stopped run_and_stop(const std::string& config, const std::filesystem::path& folder, int signal) {
    const std::string messages = folder.string() + ".txt";
    const pid_t child = ::fork();
    if (child == 0) {
        const FakeEngine engine;
        const std::string name = folder.string();
        const std::vector<const char*> words = {"kreisel", "run", config.c_str(), "-o", name.c_str(), "-j", "1"};
        if (std::freopen(messages.c_str(), "w", stderr) == nullptr) { ::_exit(99); }
        ::_exit(kreisel_main(static_cast<int>(words.size()), words.data(), engine, engine));
    }
    for (int i = 0; i < 500 && (!std::filesystem::exists(folder / "trajectories") || trajectory_parts(folder).empty());
         ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1200));
    ::kill(child, signal);
    int status = 0;
    ::waitpid(child, &status, 0);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status), contents(messages)};
}

}  // namespace

TEST_CASE("a stopped run leaves the samples that were taken, and a resume replaces them by the same file") {
    const ScratchFolder scratch;
    const std::string config = scratch.file("slow.json", slow);
    REQUIRE(run_program({"run", config, "-o", (scratch / "whole").string()}).code == 0);
    REQUIRE(trajectory_parts(scratch / "whole").empty());
    const auto file =
        nlohmann::json::parse(contents(scratch / "whole" / "results.jsonl"))["trajectory"].get<std::string>();
    const std::string whole = contents(scratch / "whole" / file);
    for (const int signal : {SIGTERM, SIGINT, SIGKILL}) {
        CAPTURE(signal);
        const auto folder = scratch / ("stopped" + std::to_string(signal));
        const Stopped stopped = run_and_stop(config, folder, signal);
        CHECK(stopped.status == (signal == SIGKILL ? -SIGKILL : 130));
        const auto parts = trajectory_parts(folder);
        REQUIRE(parts.size() == 1);
        const std::string part = contents(parts.front());
        const auto samples = std::count(part.begin(), part.end(), '\n') - 1;
        // When the run is killed a second of samples may be missing, 200 of them.
        CHECK(samples >= (signal == SIGKILL ? 1 : 100));
        CHECK(samples < 301);
        CHECK(part == whole.substr(0, part.size()));
        CHECK(part.back() == '\n');
        if (signal != SIGKILL) {
            CHECK_THAT(stopped.messages, Catch::Contains("unfinished cell: " + parts.front().string()));
        }
        REQUIRE(run_program({"run", config, "-o", folder.string(), "--resume"}).code == 0);
        CHECK(contents(folder / file) == whole);
        CHECK(trajectory_parts(folder).empty());
    }
}

TEST_CASE("samples are written at once, then about once a second, and their sum is that of the file") {
    const ScratchFolder scratch;
    std::filesystem::create_directories(scratch / "trajectories");
    const auto file = scratch / trajectory_file("a1"), part = std::filesystem::path(file.string() + ".part");
    TrajectoryFile samples(file);
    CHECK(samples.sum().empty());
    samples.begin({{"t", "s"}, {"x1", "m"}});
    CHECK_FALSE(std::filesystem::exists(part));
    samples.add("0,1");
    CHECK(contents(part) == "t [s],x1 [m]\n0,1\n");
    samples.add("1,2");
    CHECK(contents(part) == "t [s],x1 [m]\n0,1\n");
    std::this_thread::sleep_for(std::chrono::milliseconds(1050));
    samples.add("2,3");
    CHECK(contents(part) == "t [s],x1 [m]\n0,1\n1,2\n2,3\n");
    samples.add("3,4");
    samples.keep();
    CHECK(contents(file) == "t [s],x1 [m]\n0,1\n1,2\n2,3\n3,4\n");
    CHECK(samples.sum() == hash_text(contents(file)));
    CHECK_FALSE(std::filesystem::exists(part));

    TrajectoryFile other(file);  // a part of an earlier run is written over
    std::ofstream(part) << "a much longer text than what comes now, of an earlier run\n";
    other.begin({{"t", "s"}});
    other.add("0");
    CHECK(contents(part) == "t [s]\n0\n");
    other.discard();
    CHECK_FALSE(std::filesystem::exists(part));

    TrajectoryFile nowhere(scratch / "absent" / "a1.csv");
    nowhere.begin({{"t", "s"}});
    CHECK_THROWS_AS(nowhere.add("0"), FileError);
}

TEST_CASE("a full disk under the samples ends the run with 3, and a cell that throws leaves no samples") {
    const ScratchFolder scratch;
    const std::string config = scratch.file("slow.json", slow);
    const Plan plan = plan_of(parse_document("t", slow), one_engine);
    std::filesystem::create_directories(scratch / "out" / "trajectories");
    std::filesystem::create_symlink("/dev/full",
                                    scratch / "out" / (trajectory_file(plan.cells.at(0).hash()) + ".part"));
    const auto result = run_program({"run", config, "-o", (scratch / "out").string()});
    CHECK(result.code == 3);
    CHECK_THAT(result.messages, Catch::Contains("No space left on device"));
    std::string throwing = slow;
    throwing.replace(throwing.find("fake/slow"), 9, "fake/throws");
    CHECK(run_program({"run", scratch.file("throws.json", throwing), "-o", (scratch / "thrown").string()}).code == 1);
    CHECK(std::filesystem::is_empty(scratch / "thrown" / "trajectories"));
}

TEST_CASE("each problem of a run has its own geometry") {
    const ScratchFolder scratch;
    const std::string config = scratch.file("c.json", R"({"name": "c", "kind": "trajectory", "problems": [
        {"name": "heavy_top", "label": "a", "parameters": {"mass": [1, 2]}},
        {"name": "heavy_top", "label": "b", "parameters": {"mass": 3}}],
        "methods": ["rkmk/rk4", "rkmk/midpoint"], "time": {"end": 1, "steps": 4}, "output": {"samples": 2}})");
    REQUIRE(run_program({"run", config, "-o", (scratch / "out").string()}).code == 0);
    const auto mechanisms = read_geometry(scratch / "out");
    REQUIRE(mechanisms.size() == 3);
    for (std::size_t i = 0; i < 3; ++i) {
        CHECK(mechanisms[i].cells.size() == 2);
        CHECK(mechanisms[i].geometry.bodies.at(0).mass == static_cast<double>(i + 1));
    }
}
