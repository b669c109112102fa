// SPDX-License-Identifier: BSD-3-Clause
//
// Descriptors, file sizes and terminals that a run does not have: it goes on with what there is, or stops with 3 and
// keeps what it has.
#include <fcntl.h>
#include <sys/resource.h>

#include <catch2/catch.hpp>
#include <sstream>

#include "driver/campaign/workers/limits.hpp"
#include "records/cell/line.hpp"
#include "tests/driver/command_line.hpp"
#include "tests/driver/workers/program_process.hpp"

using namespace kreisel;

namespace {

// How a run of good cells ends, and what it says, in a process that is prepared.
struct Ended {
    int code = 0;
    std::string said;
};

Ended run_starved(const ScratchFolder& scratch, const std::string& name, const std::function<void()>& prepare,
                  const std::string& jobs = "2") {
    const FakeEngine engine;
    const std::string said = (scratch / (name + ".txt")).string(), config = scratch.file("c.json", good_config());
    ProgramProcess program({"run", config, "-o", (scratch / name).string(), "-j", jobs}, engine, [&] {
        std::freopen(said.c_str(), "w", stderr);
        prepare();
    });
    const int code = program.wait();
    return {code, contents(said)};
}

void set_limit(__rlimit_resource which, rlim_t value) {
    const rlimit limit{value, value};
    ::setrlimit(which, &limit);
}

long whole_lines(const std::filesystem::path& journal) {
    long count = 0;
    std::istringstream stream(contents(journal));
    for (std::string line; std::getline(stream, line);) {
        REQUIRE(journalled_cell(line));
        ++count;
    }
    return count;
}

}  // namespace

TEST_CASE("without standard descriptors nothing is printed into the journal") {
    const ScratchFolder scratch;
    const auto ended = run_starved(scratch, "out", [] {
        for (const int standard : {0, 1, 2}) { ::close(standard); }
    });
    CHECK(ended.code == 0);
    CHECK(whole_lines(scratch / "out" / "journal.jsonl") == 12);
    const auto again =
        run_program({"run", (scratch / "c.json").string(), "-o", (scratch / "out").string(), "--resume"});
    CHECK(again.code == 0);
    CHECK_THAT(again.messages, Catch::Contains("12 taken over"));
}

TEST_CASE("a closed pipe for messages does not end a run") {
    const ScratchFolder scratch;
    const auto ended = run_starved(scratch, "out", [] {
        int ends[2] = {-1, -1};
        ::pipe(ends);
        ::dup2(ends[1], STDERR_FILENO);
        ::close(ends[0]);
        ::close(ends[1]);
    });
    CHECK(ended.code == 0);
    CHECK(whole_lines(scratch / "out" / "journal.jsonl") == 12);
}

TEST_CASE("where descriptors are few a run goes on with fewer workers, and says so") {
    const ScratchFolder scratch;
    const int next = ::open("/dev/null", O_RDONLY);
    ::close(next);
    const auto few = run_starved(
        scratch, "few", [&] { set_limit(RLIMIT_NOFILE, static_cast<rlim_t>(next) + 9); }, "8");
    CHECK(few.code == 0);
    CHECK_THAT(few.said, Catch::Contains(" of 8 workers are at work; no more can be started: Too many open files"));
    const auto none = run_starved(scratch, "none", [&] { set_limit(RLIMIT_NOFILE, static_cast<rlim_t>(next) + 4); });
    CHECK(none.code == 3);
    CHECK_THAT(none.said, Catch::Contains("Too many open files"));
}

TEST_CASE("a file that may not become larger ends a run with 3, and the journal is whole") {
    const ScratchFolder scratch;
    const auto ended = run_starved(scratch, "out", [] { set_limit(RLIMIT_FSIZE, 5000); });
    CHECK(ended.code == 3);
    CHECK_THAT(ended.said, Catch::Contains("File too large"));
    const long lines = whole_lines(scratch / "out" / "journal.jsonl");
    CHECK(lines > 0);
    CHECK(lines < 12);
    CHECK(run_program({"run", (scratch / "c.json").string(), "-o", (scratch / "out").string(), "--resume"}).code == 0);
}

TEST_CASE("a folder that cannot be written is named") {
    const ScratchFolder scratch;
    const std::string config = scratch.file("c.json", good_config());
    const auto result = run_program({"run", config, "-o", "/proc/self/out"});
    CHECK(result.code == 3);
    CHECK_THAT(result.messages, Catch::Contains("/proc/self/out"));
}

TEST_CASE("where no process can be started a run ends with 3 and says so") {
    const ScratchFolder scratch;
    std::filesystem::permissions(scratch / ".", std::filesystem::perms::all);
    const auto ended = run_starved(scratch, "out", [] {
        set_limit(RLIMIT_NPROC, 0);
        if (::geteuid() == 0) { CHECK(::setuid(65534) == 0); }  // the limit is none for root
    });
    CHECK(ended.code == 3);
    CHECK_THAT(ended.said, Catch::Contains("the process that starts workers cannot be made: Resource temporarily"));
}

TEST_CASE("a plan that does not fit into memory ends a run with 3") {
    const ScratchFolder scratch;
    std::string counts = "1";
    for (int i = 2; i <= 2000; ++i) { counts += "," + std::to_string(i); }
    const FakeEngine engine;
    const std::string said = (scratch / "said.txt").string(),
                      config = scratch.file("large.json", R"({"name": "large", "kind": "drift", "methods": ["rkmk/*"],
        "problems": [{"name": "heavy_top", "parameters": {"mass": [)" +
                                                              counts + R"(]}}],
        "time": {"end": 1, "steps": [)" + counts + "]}}");
    ProgramProcess program({"run", config, "-o", (scratch / "out").string()}, engine, [&] {
        std::freopen(said.c_str(), "w", stderr);
        limit_memory(64U << 20U);
    });
    CHECK(program.wait() == 3);
    CHECK_THAT(contents(said), Catch::Contains("memory"));
    CHECK_FALSE(std::filesystem::exists(scratch / "out"));
}
