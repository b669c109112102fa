// SPDX-License-Identifier: BSD-3-Clause
//
// Whole campaigns: same bytes for any number of workers, resumes, shards, interruptions, full disks.
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "driver/cli/cli.hpp"
#include "records/cell/line.hpp"
#include "records/provenance.hpp"
#include "support/files.hpp"
#include "tests/driver/command_line.hpp"

using namespace kreisel;

namespace {

// 96 cells with failures, skipped ones, trajectories and references.
const std::string mixed = R"({
  "name": "mixed", "kind": "convergence", "precision": ["double", "quad"],
  "problems": ["heavy_top", {"name": "free_top", "label": "light", "parameters": {"mass": 0.1}}],
  "formulations": ["SO3xR3", "SE3"],
  "methods": ["rkmk/rk4", "baseline/rk4_quaternion", "fake/nan", "fake/throws", "fake/throws_int", "fake/infinite"],
  "time": {"end": 1, "steps": [8, 4]}, "output": {"samples": 2}})";

std::string one_method(const std::string& method, long steps, const std::string& problem = "heavy_top",
                       double end = 1) {
    return nlohmann::json({{"name", "one"},
                           {"kind", "convergence"},
                           {"problems", {problem}},
                           {"methods", {method}},
                           {"time", {{"end", end}, {"steps", steps}}}})
        .dump();
}

ProgramResult run(const std::string& config, const std::filesystem::path& folder, std::vector<std::string> more = {},
                  const Engine& engine = FakeEngine()) {
    more.insert(more.begin(), {"run", config, "-o", folder.string()});
    return run_program(more, engine);
}

void require_same_results(const std::filesystem::path& a, const std::filesystem::path& b) {
    CHECK(contents(a / "results.jsonl") == contents(b / "results.jsonl"));
    CHECK(contents(a / "results.csv") == contents(b / "results.csv"));
    REQUIRE(!contents(a / "results.jsonl").empty());
}

long lines_of(const std::filesystem::path& file) {
    const std::string text = contents(file);
    return std::count(text.begin(), text.end(), '\n');
}

// Runs the program in a process of its own, sends it a signal, and returns its exit code or minus the signal.
int run_and_signal(const std::string& config, const std::filesystem::path& folder, int signal, int milliseconds,
                   bool resume = false) {
    const pid_t child = ::fork();
    if (child == 0) {
        const FakeEngine engine;
        const std::string name = folder.string();
        std::vector<const char*> words = {"kreisel", "run", config.c_str(), "-o", name.c_str(), "-j", "2"};
        if (resume) { words.push_back("--resume"); }
        ::close(STDERR_FILENO);
        ::_exit(kreisel_main(static_cast<int>(words.size()), words.data(), engine, engine));
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
    ::kill(child, signal);
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

}  // namespace

TEST_CASE("the results are the same bytes for any number of workers and any sharding") {
    const ScratchFolder scratch;
    const std::string config = scratch.file("mixed.json", mixed);
    const auto first = run(config, scratch / "j1", {"-j", "1"});
    CHECK(first.code == 1);
    CHECK(lines_of(scratch / "j1" / "results.jsonl") == 96);
    for (const char* jobs : {"2", "4", "16"}) {
        run(config, scratch / jobs, {"-j", jobs});
        require_same_results(scratch / "j1", scratch / jobs);
    }
    for (const char* shard : {"3/3", "1/3", "2/3"}) { run(config, scratch / "shards", {"--shard", shard}); }
    CHECK(run_program({"merge", (scratch / "shards").string()}).code == 1);
    require_same_results(scratch / "j1", scratch / "shards");
    run(config, scratch / "a", {"--shard", "1/2"});
    run(config, scratch / "b", {"--shard", "2/2"});
    CHECK(run_program({"merge", (scratch / "a").string()}).messages.find("48 missing") != std::string::npos);
    run_program({"merge", (scratch / "b").string(), (scratch / "a").string(), "-o", (scratch / "ab").string()});
    require_same_results(scratch / "j1", scratch / "ab");
    const FakeEngine engine;
    run(config, scratch / "ab", {"--resume"}, engine);
    CHECK(engine.runs == 32);  // cells with exceptions are tried again, the rest is done
    CHECK(engine.references == 0);
    require_same_results(scratch / "j1", scratch / "ab");
    for (const auto& entry : std::filesystem::directory_iterator(scratch / "j1" / "trajectories")) {
        CHECK(contents(entry.path()) == contents(scratch / "ab" / "trajectories" / entry.path().filename().string()));
    }
}

TEST_CASE("failures stay in their own cells and are listed with status, time and method") {
    const ScratchFolder scratch;
    const auto result = run(scratch.file("mixed.json", mixed), scratch / "out");
    CHECK(result.messages.find("failed: non_finite at t = 0.5: fake/nan on light SE3") != std::string::npos);
    CHECK(result.messages.find("this method always throws") != std::string::npos);
    CHECK(result.messages.find("other than a std::exception") != std::string::npos);
    CHECK(result.messages.find("failed: non_finite at t = 1: fake/infinite") != std::string::npos);
    CHECK(result.messages.find("invariant.energy.final is inf, not a finite number") != std::string::npos);
    CHECK(result.messages.find("mixed: 24 ok, 8 skipped, 64 failed") != std::string::npos);
    const auto manifest = nlohmann::json::parse(contents(scratch / "out" / "manifest.json"));
    CHECK(manifest["cells"]["failed"] == 64);
    CHECK(manifest["cells"]["missing"] == 0);
    CHECK(manifest["ended"].is_string());
    CHECK(manifest["config"]["time"]["steps"] == nlohmann::json({8, 4}));
}

TEST_CASE(
    "a reference is computed once for each problem, and past its horizon errors are measured where they are large") {
    const ScratchFolder scratch;
    const FakeEngine engine;
    run(scratch.file("mixed.json", mixed), scratch / "out", {"-j", "4"}, engine);
    CHECK(engine.references == 2);
    const auto ended_at = [&](double end, long steps) {
        const auto folder = scratch / ("steps" + std::to_string(steps) + "to" + std::to_string(end));
        const auto said = run(scratch.file("far.json", one_method("rkmk/rk4", steps, "heavy_top", end)), folder);
        const bool noted = said.messages.find(
                               "note: heavy_top: 1 cell ends at 60 s, past the horizon T* = 50 s of its reference, "
                               "which is uncertain by 1.0e-04 m there") != std::string::npos;
        CHECK(noted == (end > 50));
        return nlohmann::json::parse(contents(folder / "results.jsonl"));
    };
    const auto within = ended_at(40, 4), large = ended_at(60, 2), small = ended_at(60, 4);
    CHECK(within["metrics"].contains("error.position"));
    CHECK_FALSE(within["reference"].contains("past_horizon"));
    CHECK(large["metrics"]["error.position"] == 0.0625);
    CHECK(large["reference"]["past_horizon"] == true);
    CHECK(large["reference"]["error"]["error.position"] == 1e-4);
    CHECK_FALSE(small["metrics"].contains("error.position"));  // 1/256 is below 100 times 1e-4
    CHECK(small["reference"]["horizon"] == 50);
}

TEST_CASE("a reference that fails fails the cells that need it") {
    const ScratchFolder scratch;
    const auto result = run(scratch.file("c.json", one_method("rkmk/rk4", 2, "double_pendulum", 200)), scratch / "out");
    CHECK(result.code == 1);
    CHECK(result.messages.find("no_reference(exception)") != std::string::npos);
    CHECK(result.messages.find("do not agree") != std::string::npos);
}

TEST_CASE("a resumed run computes only what is missing or damaged and gives the same bytes") {
    const ScratchFolder scratch;
    const std::string config = scratch.file("good.json", good_config());
    run(config, scratch / "whole");
    const std::string journal = contents(scratch / "whole" / "journal.jsonl");
    for (std::size_t length = 0; length <= journal.size(); length += 331) {
        const auto folder = scratch / ("cut" + std::to_string(length));
        std::filesystem::create_directories(folder);
        std::ofstream(folder / "journal.jsonl") << journal.substr(0, length);
        const FakeEngine engine;
        CHECK(run(config, folder, {"--resume"}, engine).code == 0);
        const auto kept = std::count(journal.begin(), journal.begin() + static_cast<long>(length), '\n');
        CHECK(engine.runs == 12 - kept);
        require_same_results(scratch / "whole", folder);
    }
    const FakeEngine engine;
    const auto again = run(config, scratch / "whole", {"--resume"}, engine);
    CHECK(engine.runs == 0);
    CHECK(engine.references == 0);
    CHECK(again.messages.find("12 taken over") != std::string::npos);
}

TEST_CASE("the cells of another build are computed again, which is said once, and then forgotten") {
    const ScratchFolder scratch;
    const std::string config = scratch.file("good.json", good_config());
    run(config, scratch / "out");
    const auto results = contents(scratch / "out" / "results.jsonl");
    const auto journal = scratch / "out" / "journal.jsonl";
    std::istringstream lines(contents(journal));
    std::string foreign;
    for (std::string line; std::getline(lines, line);) {
        foreign += journal_line(read_journal_line(line, build_id()).value(), "another_build_id") + "\n";
    }
    std::ofstream(journal) << foreign;
    const FakeEngine engine;
    const auto second = run(config, scratch / "out", {"--resume"}, engine);
    CHECK(engine.runs == 12);
    CHECK(second.messages.find("12 cells of another build are computed again") != std::string::npos);
    CHECK(second.messages.find("left out") == std::string::npos);
    CHECK(lines_of(journal) == 12);
    CHECK(contents(scratch / "out" / "results.jsonl") == results);
    const auto third = run(config, scratch / "out", {"--resume"}, engine);
    CHECK(engine.runs == 12);
    CHECK(third.messages.find("another build") == std::string::npos);
}

TEST_CASE("cells with exceptions and lost trajectories run again, and a new label needs no new run") {
    const ScratchFolder scratch;
    const std::string config = scratch.file("mixed.json", mixed);
    run(config, scratch / "out");
    const FakeEngine engine;
    run(config, scratch / "out", {"--resume"}, engine);
    CHECK(engine.runs == 32);  // fake/throws, fake/throws_int
    for (const auto& entry : std::filesystem::directory_iterator(scratch / "out" / "trajectories")) {
        std::ofstream(entry.path(), std::ios::app) << "1,1\n";
    }
    run(config, scratch / "out", {"--resume"}, engine);
    CHECK(engine.runs == 32 + 32 + 56);
    std::string renamed = mixed;
    renamed.replace(renamed.find("\"light\""), 7, "\"heavier\"");
    run(scratch.file("renamed.json", renamed), scratch / "out", {"--resume"}, engine);
    CHECK(engine.runs == 32 + 32 + 56 + 32);
    CHECK(contents(scratch / "out" / "results.jsonl").find("\"label\":\"heavier\"") != std::string::npos);
    CHECK(contents(scratch / "out" / "results.jsonl").find("\"label\":\"light\"") == std::string::npos);
}

TEST_CASE("a folder with results is not written over by accident") {
    const ScratchFolder scratch;
    const std::string config = scratch.file("good.json", good_config());
    REQUIRE(run(config, scratch / "out").code == 0);
    const std::string journal = contents(scratch / "out" / "journal.jsonl");
    const auto second = run(config, scratch / "out");
    CHECK(second.code == 2);
    CHECK(second.messages.find("--resume") != std::string::npos);
    CHECK(contents(scratch / "out" / "journal.jsonl") == journal);
    CHECK(run(config, scratch / "out", {"--overwrite"}).code == 0);
    CHECK(run(config, scratch / "out", {"--overwrite", "--resume"}).code == 2);
    const FolderLock lock(scratch / "out", "");
    CHECK(run(config, scratch / "out", {"--resume"}).code == 3);
    CHECK(run(config, config).code == 2);
}

TEST_CASE("a full disk ends the run with 3 and keeps what was journalled") {
    const ScratchFolder scratch;
    const std::string config = scratch.file("good.json", good_config());
    std::filesystem::create_directories(scratch / "out");
    std::filesystem::create_symlink("/dev/full", scratch / "out" / "journal.jsonl");
    const auto result = run(config, scratch / "out");
    CHECK(result.code == 3);
    CHECK(result.messages.find("No space left on device") != std::string::npos);
    CHECK(run(config, "/proc/kreisel_cannot_be").code == 3);
}

TEST_CASE("interrupted: the results so far are valid and a resume completes them") {
    const ScratchFolder scratch;
    const std::string config = scratch.file("slow.json", R"({"name": "slow", "kind": "drift", "problems": ["heavy_top"],
        "methods": ["fake/slow"], "formulations": ["SO3xR3", "SE3", "SO3"], "time": {"end": 1,
            "steps": [100, 101, 102, 103]}})");
    for (const int signal : {SIGINT, SIGTERM}) {
        const auto folder = scratch / std::to_string(signal);
        CHECK(run_and_signal(config, folder, signal, 350) == 130);
        const long done = lines_of(folder / "results.jsonl");
        CHECK(done > 0);
        CHECK(done < 12);
        CHECK(done == lines_of(folder / "journal.jsonl"));
        CHECK(run(config, folder, {"--resume"}).code == 0);
        CHECK(lines_of(folder / "journal.jsonl") == 12);
    }
    require_same_results(scratch / std::to_string(SIGINT), scratch / std::to_string(SIGTERM));
}

TEST_CASE("an interrupted reference fails no cell, and a resume computes it") {
    const ScratchFolder scratch;
    const std::string config = scratch.file("long.json", one_method("rkmk/rk4", 2, "heavy_top", 1200));
    const auto folder = scratch / "out";
    CHECK(run_and_signal(config, folder, SIGTERM, 300) == 130);
    const auto manifest = nlohmann::json::parse(contents(folder / "manifest.json"));
    CHECK(manifest["cells"]["missing"] == 1);
    CHECK(manifest["ended"].is_string());
    CHECK(lines_of(folder / "journal.jsonl") == 0);
    CHECK(std::filesystem::is_empty(folder / "references"));
    CHECK(run(config, folder, {"--resume"}).code == 0);
    CHECK(nlohmann::json::parse(contents(folder / "results.jsonl"))["status"] == "ok");
}

TEST_CASE("a method that ignores stop requests is abandoned") {
    const ScratchFolder scratch;
    const std::string config = scratch.file("deaf.json", one_method("fake/deaf", 60'000));
    const auto start = std::chrono::steady_clock::now();
    CHECK(run_and_signal(config, scratch / "out", SIGTERM, 300) == 130);
    CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(5));
    CHECK(nlohmann::json::parse(contents(scratch / "out" / "manifest.json"))["cells"]["missing"] == 1);
}

TEST_CASE("killed at any instant, a run is completed by a resume to the same bytes") {
    const ScratchFolder scratch;
    const std::string config = scratch.file("slow.json", R"({"name": "slow", "kind": "drift", "problems": ["heavy_top"],
        "methods": ["fake/slow", "rkmk/rk4"], "time": {"end": 1, "steps": [10, 12, 14, 16, 18, 20]}})");
    run(config, scratch / "whole");
    for (int i = 0; i < 10; ++i) {
        const auto folder = scratch / ("killed" + std::to_string(i));
        run_and_signal(config, folder, SIGKILL, 3 + 7 * i);
        CHECK(run(config, folder, {"--resume"}).code == 0);
        require_same_results(scratch / "whole", folder);
    }
}

TEST_CASE("several configs go to folders of their own, and one bad one stops all") {
    const ScratchFolder scratch;
    const std::string good = scratch.file("good.json", good_config()),
                      one = scratch.file("one.json", one_method("rkmk/rk4", 2));
    CHECK(run_program({"run", good, one, "-o", (scratch / "out").string()}).code == 0);
    CHECK(std::filesystem::exists(scratch / "out" / "good" / "results.csv"));
    CHECK(std::filesystem::exists(scratch / "out" / "one" / "results.csv"));
    CHECK(run_program({"run", good, good, "-o", (scratch / "twice").string()}).code == 2);
    const std::string bad = scratch.file("bad.json", "{}");
    CHECK(run_program({"run", good, bad, "-o", (scratch / "none").string()}).code == 2);
    CHECK_FALSE(std::filesystem::exists(scratch / "none"));
}

TEST_CASE("an interrupted shard says how it is continued") {
    const ScratchFolder scratch;
    const std::string config = scratch.file("slow.json", R"({"name": "slow", "kind": "drift", "problems": ["heavy_top"],
        "methods": ["fake/slow"], "formulations": ["SO3xR3", "SE3"], "time": {"end": 1, "steps": [3000, 3001]}})");
    const auto folder = scratch / "out";
    const std::jthread interrupter([&](const std::stop_token& stop) {
        while (!stop.stop_requested()) {
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
            // Signals are caught before the manifest is written.
            if (std::filesystem::exists(folder / "manifest.2-of-2.json")) {
                ::kill(::getpid(), SIGTERM);
                return;
            }
        }
    });
    const auto result = run(config, folder, {"--shard", "2/2", "-j", "1"});
    CHECK(result.code == 130);
    CHECK(result.messages.find("interrupted with 2 cells to go; continue with: kreisel run " + config + " -o " +
                               folder.string() + " --shard 2/2 --resume\n") != std::string::npos);
    CHECK(nlohmann::json::parse(contents(folder / "manifest.2-of-2.json"))["cells"]["missing"] == 2);
}
