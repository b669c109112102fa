// SPDX-License-Identifier: BSD-3-Clause
//
// Interrupts, sent once or twice, and kills: what stops, when, and what is left.
#include <catch2/catch.hpp>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "driver/campaign/interrupt.hpp"
#include "tests/driver/command_line.hpp"
#include "tests/driver/workers/program_process.hpp"
#include "tests/driver/workers/saboteurs.hpp"
#include "tests/driver/workers/shared_count.hpp"

using namespace kreisel;

namespace {

std::string of_method(const std::string& method, const std::string& name = "one") {
    return nlohmann::json({{"name", name},
                           {"kind", "drift"},
                           {"problems", {"heavy_top"}},
                           {"methods", {"rkmk/rk4", method}},
                           {"time", {{"end", 1}, {"steps", {4, 2}}}}})
        .dump();
}

// Whether a process runs; one that has ended and is not reaped does not.
bool runs(long process) {
    std::ifstream file("/proc/" + std::to_string(process) + "/stat");
    std::string number, name, state;
    return file >> number >> name >> state && state != "Z" && state != "X";
}

}  // namespace

TEST_CASE("a second signal soon after the first does not kill, and the run stops within two seconds") {
    const ScratchFolder scratch;
    const std::string config = scratch.file("c.json", of_method("sabotage/sleep"));
    for (const int signal : {SIGINT, SIGTERM}) {
        const Saboteurs engine;
        const auto folder = scratch / std::to_string(signal);
        ProgramProcess program({"run", config, "-o", folder.string(), "-j", "2"}, engine, say_nothing);
        REQUIRE(comes_true([&] { return engine.processes.size() == 2; }));
        const auto start = std::chrono::steady_clock::now();
        program.signal(signal);
        pause_for(0.3);
        program.signal(signal);
        CHECK(program.wait() == 130);
        CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(2));
        const auto manifest = nlohmann::json::parse(contents(folder / "manifest.json"));
        CHECK(manifest["cells"]["missing"] == 2);
        CHECK(contents(folder / "results.jsonl").find("\"status\":\"ok\"") != std::string::npos);
        for (const long process : engine.processes) { CHECK_FALSE(runs(process)); }
    }
}

TEST_CASE("a signal long after the first ends a program that does not stop") {
    const auto ends = [](double seconds) {
        const pid_t child = ::fork();
        if (child == 0) {
            const InterruptGuard guard;
            ::raise(SIGINT);
            pause_for(seconds);
            ::raise(SIGINT);
            ::_exit(InterruptGuard::requested() ? 7 : 8);
        }
        int status = 0;
        ::waitpid(child, &status, 0);
        return status;
    };
    CHECK(WEXITSTATUS(ends(0.3)) == 7);
    const int late = ends(2.5);
    CHECK((WIFSIGNALED(late) && WTERMSIG(late) == SIGINT));
}

TEST_CASE("kill -9 of a run leaves no process behind") {
    const ScratchFolder scratch;
    const Saboteurs engine;
    const std::string config = scratch.file("c.json", of_method("sabotage/sleep"));
    ProgramProcess program({"run", config, "-o", (scratch / "out").string(), "-j", "2"}, engine, say_nothing);
    REQUIRE(comes_true([&] { return engine.processes.size() == 2; }));
    for (const long process : engine.processes) { CHECK(runs(process)); }
    program.signal(SIGKILL);
    CHECK(program.wait() == -SIGKILL);
    for (const long process : engine.processes) {
        CHECK(comes_true([process] { return !runs(process); }));
    }
    CHECK(
        run_program({"run", config, "-o", (scratch / "out").string(), "--resume", "--filter", "methods=rkmk/*"}, engine)
            .code == 0);
}

TEST_CASE("a run that is told so ends with its parent, and no other does") {
    const ScratchFolder scratch;
    const std::string config = scratch.file("c.json", of_method("sabotage/sleep"));
    for (const bool told : {true, false}) {
        const Saboteurs engine;
        const SharedNumbers programs;
        std::vector<std::string> words = {"run", config, "-o", (scratch / std::to_string(told)).string(), "-j", "2"};
        if (told) { words.emplace_back("--with-parent"); }
        const pid_t parent = ::fork();
        if (parent == 0) {
            const ProgramProcess program(words, engine, [&] { programs.push_back(::getpid()), say_nothing(); });
            pause_for(1000);
        }
        REQUIRE(comes_true([&] { return engine.processes.size() == 2; }));
        ::kill(parent, SIGKILL);
        ::waitpid(parent, nullptr, 0);
        const long program = programs[0];
        if (told) {
            CHECK(comes_true([program] { return !runs(program); }));
        } else {
            pause_for(0.3);
            CHECK(runs(program));
            ::kill(static_cast<pid_t>(program), SIGKILL);
        }
        for (const long process : engine.processes) {
            CHECK(comes_true([process] { return !runs(process); }));
        }
    }
}

TEST_CASE("an interrupted run of several configs says how those that are left are computed, in quotes where needed") {
    const ScratchFolder scratch;
    const Saboteurs engine;
    const std::string done = scratch.file("a.json", of_method("rkmk/midpoint", "a")),
                      deaf = scratch.file("it's.json", of_method("sabotage/sleep", "b")),
                      next = scratch.file("c.json", of_method("rkmk/midpoint", "c")),
                      out = (scratch / "some results").string(), said = (scratch / "said").string();
    ProgramProcess program({"run", done, deaf, next, "-o", out, "-j", "2", "--timeout", "100"}, engine,
                           [&] { std::freopen(said.c_str(), "w", stderr); });
    REQUIRE(comes_true([&] { return engine.processes.size() == 2; }));
    program.signal(SIGINT);
    CHECK(program.wait() == 130);
    std::string quoted = deaf;
    quoted.replace(quoted.find('\''), 1, "'\\''");
    CHECK_THAT(contents(said), Catch::Contains("interrupted with 2 cells to go; continue with: kreisel run '" + quoted +
                                               "' " + next + " -o '" + out + "' --timeout 100 --resume\n"));
}
