// SPDX-License-Identifier: BSD-3-Clause
//
// Result folders that do not fit together, or are not of the kind that a command expects: merge, verify, resume.
#include <catch2/catch.hpp>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "records/cell/line.hpp"
#include "records/journal.hpp"
#include "records/manifest.hpp"
#include "records/provenance.hpp"
#include "records/sums/sum_list.hpp"
#include "support/errors.hpp"
#include "support/files.hpp"
#include "tests/driver/command_line.hpp"
#include "tests/driver/other_engine.hpp"

using namespace kreisel;

namespace {

/// The good config, run as two shards into one folder each.
struct Shards {
    ScratchFolder scratch;
    std::string config = scratch.file("good.json", good_config());
    std::filesystem::path a = scratch / "a", b = scratch / "b";

    Shards() {
        REQUIRE(run_program({"run", config, "-o", a.string(), "--shard", "1/2"}).code == 0);
        REQUIRE(run_program({"run", config, "-o", b.string(), "--shard", "2/2"}).code == 0);
    }
    ProgramResult merge() const {
        return run_program({"merge", a.string(), b.string(), "-o", (scratch / "ab").string()});
    }
};

/// Sets one value of a manifest.
void change(const std::filesystem::path& file, const std::string& pointer, const nlohmann::json& value) {
    auto json = nlohmann::ordered_json::parse(contents(file));
    REQUIRE(json.contains(nlohmann::ordered_json::json_pointer(pointer)));
    json[nlohmann::ordered_json::json_pointer(pointer)] = value;
    write_summed(file, json);
}

/// The journal's lines, as written by another build, whose name is as long.
void make_foreign(const std::filesystem::path& journal) {
    std::istringstream lines(contents(journal));
    std::string text;
    for (std::string line; std::getline(lines, line);) {
        text += journal_line(read_journal_line(line, build_id()).value(), "another_build_id") + "\n";
    }
    std::ofstream(journal) << text;
}

/// A second route without a result to compare.
class SilentRoute final : public OtherEngine {
  public:
    ReferenceCheck check_reference(const std::string&, const ParameterValues&, const BeginState*,
                                   const Reference&) const override {
        return {};
    }
};

}  // namespace

TEST_CASE("shards are merged with their references, and what did not run is counted") {
    const Shards shards;
    const auto merged = shards.merge();
    CHECK(merged.code == 0);
    CHECK_THAT(merged.messages, Catch::Contains("good: 12 ok, 0 skipped, 0 failed, 0 missing; results in "));
    CHECK(files_like(shards.scratch / "ab" / "references", "", ".json").size() == 1);
    const auto half = run_program({"merge", shards.a.string()});
    CHECK(half.code == 3);
    CHECK_THAT(half.messages, Catch::Contains("6 missing"));
    const auto listed = [&] {
        std::size_t count = 0;
        for (auto at = half.messages.find("missing: rkmk/"); at != std::string::npos; ++count) {
            at = half.messages.find("missing: rkmk/", at + 1);
        }
        return count;
    };
    CHECK(listed() == 6);
    const std::string folder = shards.a.string(), manifest = folder + "/manifest.json";
    CHECK_THAT(half.messages, Catch::Contains("compute what is missing with: kreisel run " + manifest + " -o " +
                                              folder + " --resume"));
    CHECK(run_program({"run", manifest, "-o", folder, "--resume"}).code == 0);
    CHECK(contents(shards.a / "results.jsonl") == contents(shards.scratch / "ab" / "results.jsonl"));
}

TEST_CASE("merge takes only folders of one config and this build") {
    const Shards shards;
    const auto manifest = shards.b / "manifest.2-of-2.json";

    SECTION("another config") {
        change(manifest, "/config/time/end", 2);
        const auto result = shards.merge();
        CHECK(result.code == 2);
        CHECK_THAT(result.messages, Catch::Contains("expected the same config in all folders, got another one"));
    }
    SECTION("another build") {
        change(manifest, "/program/build", "0123456789abcdef");
        const auto result = shards.merge();
        CHECK(result.code == 2);
        CHECK_THAT(result.messages,
                   Catch::Contains("expected results of this build (" + build_id() + "), got build 0123456789abcdef"));
    }
    SECTION("a manifest of something else") {
        for (const char* text : {"[]", "{}", R"({"config": {}})", R"({"config": {}, "program": 1})",
                                 R"({"config": {}, "program": {}})", R"({"config": {}, "program": {"build": 1}})"}) {
            std::ofstream(manifest) << text;
            const auto result = shards.merge();
            CHECK(result.code == 2);
            CHECK_THAT(result.messages, Catch::Contains("manifest.2-of-2.json: not a manifest of kreisel"));
        }
    }
    CHECK_FALSE(std::filesystem::exists(shards.scratch / "ab"));
}

TEST_CASE("a merge replaces results of its own config, and leaves those of another alone") {
    const Shards shards;
    const auto merged = shards.scratch / "ab";
    REQUIRE(shards.merge().code == 0);
    CHECK(shards.merge().code == 0);
    change(merged / "manifest.json", "/config/time/end", 2);
    std::ofstream(merged / "results.jsonl") << "those of the other config\n";
    const auto result = shards.merge();
    CHECK(result.code == 2);
    CHECK_THAT(result.messages, Catch::Contains("expected a new folder or results of the config that is merged"));
    CHECK(contents(merged / "results.jsonl") == "those of the other config\n");
}

TEST_CASE("cells of another build, and damaged lines, are left out of a merge, which is said") {
    const Shards shards;
    make_foreign(shards.b / "journal.2-of-2.jsonl");
    std::ofstream(shards.a / "journal.1-of-2.jsonl", std::ios::app) << "rubbish\n";
    const auto result = shards.merge();
    CHECK(result.code == 3);
    CHECK_THAT(result.messages, Catch::Contains("b: 6 cells of another build are left out\n"));
    CHECK_THAT(result.messages, Catch::Contains("journal.1-of-2.jsonl:7: damaged line left out\n"));
    CHECK_THAT(result.messages, Catch::Contains("6 ok, 0 skipped, 0 failed, 6 missing"));
}

TEST_CASE("a journal full of damage is complained of ten times and once in sum") {
    const ScratchFolder scratch;
    std::string text;
    for (int i = 0; i < 30; ++i) { text += "rubbish\n"; }
    scratch.file("journal.jsonl", text);
    const auto read = read_journals(scratch / "", "b");
    REQUIRE(read.complaints.size() == 11);
    CHECK_THAT(read.complaints[9], Catch::Contains("journal.jsonl:10: damaged line left out"));
    CHECK(read.complaints[10] == "further journal lines are left out too");
}

TEST_CASE("a path that is not a folder cannot be searched for journals") {
    const ScratchFolder scratch;
    CHECK_THROWS_AS(read_journals(scratch.file("a_file", ""), "b"), FileError);
    CHECK(read_journals(scratch / "absent", "b").cells.empty());
    CHECK_FALSE(holds_journal(scratch / "absent"));
    scratch.file("journal.jsonl", "");
    CHECK_FALSE(holds_journal(scratch / ""));
    scratch.file("journal.1-of-2.jsonl", "x");
    CHECK(holds_journal(scratch / ""));
}

TEST_CASE("verify finds results that were changed") {
    const ScratchFolder scratch;
    const std::string config = scratch.file("good.json", good_config());
    run_program({"run", config, "-o", (scratch / "out").string()});
    CHECK(run_program({"verify", (scratch / "out").string()}).code == 0);
    std::string text = contents(scratch / "out" / "results.jsonl");
    text.replace(text.find("\"error.position\":") + 17, 1, "7");
    std::ofstream(scratch / "out" / "results.jsonl") << text;
    const auto damaged = run_program({"verify", (scratch / "out").string(), "--cells", "100"});
    CHECK(damaged.code == 3);
    CHECK(damaged.messages.find("results.jsonl:1: ") != std::string::npos);
    const std::string first = text.substr(0, text.find('\n'));
    std::ofstream(scratch / "out" / "results.jsonl") << summed_line(first) << text.substr(first.size());
    record_sums(scratch / "out", {"results.jsonl"});
    const auto result = run_program({"verify", (scratch / "out").string(), "--cells", "100"});
    CHECK(result.code == 1);
    CHECK(result.out.find("1 differ") != std::string::npos);
}

TEST_CASE("verify names the build that wrote the results, and the cells that are missing") {
    const ScratchFolder scratch;
    const std::string config = scratch.file("good.json", good_config());
    const auto folder = scratch / "out";
    REQUIRE(run_program({"run", config, "-o", folder.string()}).code == 0);
    change(folder / "manifest.json", "/program/build", "0123456789abcdef");
    const std::string results = contents(folder / "results.jsonl");
    std::ofstream(folder / "results.jsonl") << "rubbish\n{\"cell\": 3}\n" << results.substr(results.find('\n') + 1);
    const auto result = run_program({"verify", folder.string(), "--cells", "100", "--seed", "7"});
    CHECK(result.code == 3);
    CHECK_THAT(result.messages,
               Catch::Contains("results.jsonl:1: not a result line: damaged: its sum does not hold\n"));
    CHECK_THAT(result.messages,
               Catch::Contains("note: written by build 0123456789abcdef, verified by build " + build_id()));
    CHECK_THAT(result.out, Catch::Contains("rkmk/midpoint on heavy_top, 8 steps: missing\n"));
    CHECK_THAT(result.out, Catch::Contains("12 of 12 cells computed again (seed 7), 1 differ or are missing\n"));
}

TEST_CASE("verify computes a missing reference, and reports that it is missing") {
    const ScratchFolder scratch;
    const std::string config = scratch.file("good.json", good_config());
    const auto folder = scratch / "out";
    REQUIRE(run_program({"run", config, "-o", folder.string()}).code == 0);
    std::filesystem::remove_all(folder / "references");
    const auto result = run_program({"verify", folder.string(), "--cells", "3"});
    CHECK(result.code == 1);
    CHECK_THAT(result.out, Catch::Contains("3 of 12 cells computed again (seed 1), 0 differ or are missing\n"));
    CHECK_THAT(result.out, Catch::Contains("heavy_top at t = 1 s: missing or damaged\n"));
    CHECK_THAT(result.out, Catch::Contains("0 of 1 references confirmed by the second route, 1 wrong or missing\n"));
}

TEST_CASE("a reference past its horizon is not compared, and one without a counterpart is not confirmed") {
    const ScratchFolder scratch;
    const std::string far = R"({"name": "far", "kind": "convergence", "problems": ["heavy_top"],
        "methods": ["rkmk/rk4"], "time": {"end": 60, "steps": 2}})";
    const std::string config = scratch.file("far.json", far);
    REQUIRE(run_program({"run", config, "-o", (scratch / "far").string()}).code == 0);
    const auto past = run_program({"verify", (scratch / "far").string()});
    CHECK(past.code == 0);
    CHECK_THAT(past.out, Catch::Contains("at t = 60 s: not compared: it lies past its horizon\n"));
    CHECK_THAT(past.out, Catch::Contains("0 of 1 references confirmed by the second route, 0 wrong or missing\n"));

    const SilentRoute silent;
    const std::string good = scratch.file("good.json", good_config());
    REQUIRE(run_program({"run", good, "-o", (scratch / "good").string()}, silent).code == 0);
    const auto result = run_program({"verify", (scratch / "good").string()}, silent);
    CHECK(result.code == 1);
    CHECK_THAT(result.out, Catch::Contains("at t = 1 s: error.position cannot be compared\n"));
}

TEST_CASE("without references there is nothing to confirm") {
    const ScratchFolder scratch;
    const std::string config = scratch.file("drift.json", R"({"name": "drift", "kind": "drift",
        "problems": ["heavy_top"], "methods": ["rkmk/rk4"], "time": {"end": 1, "steps": 2}})");
    REQUIRE(run_program({"run", config, "-o", (scratch / "out").string()}).code == 0);
    const auto result = run_program({"verify", (scratch / "out").string()});
    CHECK(result.code == 0);
    CHECK_THAT(result.out, !Catch::Contains("references"));
}
