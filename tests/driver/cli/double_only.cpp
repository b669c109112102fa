// SPDX-License-Identifier: BSD-3-Clause
//
// A program without quad precision: what it lacks is refused before anything runs, and references may be given to it.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "support/errors.hpp"
#include "tests/driver/command_line.hpp"
#include "tests/driver/other_engine.hpp"

namespace kreisel::double_only {

namespace {

constexpr int usage = static_cast<int>(Exit::usage);

/// An engine with a digest of its own.
struct BuiltEngine : OtherEngine {
    explicit BuiltEngine(std::string digest) : digest_(std::move(digest)) {}
    std::string reference_digest() const override { return digest_; }

  private:
    std::string digest_;
};

std::string config_with(const std::string& key, const nlohmann::json& value) {
    auto config = nlohmann::json::parse(good_config());
    config[key] = value;
    return config.dump();
}

/// What `check` says of a config, without quad precision.
ProgramResult checked(const std::string& config) {
    const ScratchFolder scratch;
    return run_program_in_double({"check", scratch.file("c.json", config)}, plain_engine);
}

/// Results of the good config, of a program with both precisions, beside a program with one.
struct TwoPrograms {
    ScratchFolder scratch;
    BuiltEngine whole{"sources-gcc"}, narrow{"sources-clang"};
    std::string config = scratch.file("good.json", good_config());
    std::string given = (scratch / "given").string(), folder = (scratch / "out").string();

    TwoPrograms() { REQUIRE(run_program({"run", config, "-o", given}, whole).code == 0); }
    ProgramResult run_narrow(const Engine& engine, const std::string& from) const {
        return run_program_in_double({"run", config, "-o", folder, "--references", from}, engine);
    }
};

}  // namespace

TEST_CASE("a program without quad precision refuses it where it stands, and does what needs none") {
    const auto one = checked(config_with("precision", "quad"));
    CHECK(one.code == usage);
    CHECK_THAT(one.messages, Catch::Contains("/precision: expected \"double\": this program is built without quad "
                                             "precision (KREISEL_BINARY128=OFF), got \"quad\""));
    const auto listed = checked(config_with("precision", {"double", "quad"}));
    CHECK(listed.code == usage);
    CHECK_THAT(listed.messages, Catch::Contains("/precision/1: expected \"double\""));
    CHECK(checked(config_with("metrics", {"defect.*", "invariant.energy"})).code == 0);
}

TEST_CASE("a program without quad precision refuses metrics of errors, and the kinds that measure them by themselves") {
    const auto listed = checked(config_with("metrics", {"defect.*", "error.*"}));
    CHECK(listed.code == usage);
    CHECK_THAT(listed.messages, Catch::Contains("/metrics/1: expected metrics without error.*, or --references DIR") &&
                                    Catch::Contains("a reference of heavy_top at t = 1 s, got \"error.*\""));
    const auto usual = checked(good_config());
    CHECK(usual.code == usage);
    CHECK_THAT(usual.messages, Catch::Contains("/kind: expected metrics without error.*") &&
                                   Catch::Contains("got the metrics of convergence"));
    const auto largest = nlohmann::json::parse(config_with("metrics", {"error.position.max"}));
    auto sampled = largest;
    sampled["output"] = {{"samples", 4}};
    CHECK_THAT(checked(sampled.dump()).messages,
               Catch::Contains("at t = 1 s with 4 samples, got \"error.position.max\""));
}

TEST_CASE("references that are given and damaged are named") {
    const TwoPrograms f;
    const auto given = std::filesystem::directory_iterator(f.scratch / "given" / "references")->path();
    CHECK_THAT(run_program({"check", f.config, "--references", f.given}, f.whole).messages,
               !Catch::Contains("damaged"));
    std::ofstream(given, std::ios::app) << "x";
    const auto ran = run_program({"run", f.config, "-o", f.folder, "--references", f.given}, f.whole);
    CHECK(ran.code == 0);  // they are computed
    CHECK_THAT(ran.messages, Catch::Contains(given.string() + ":1: damaged: its sum does not hold"));
}

TEST_CASE("references of a program of the same sources serve one without quad precision, with the same results") {
    const TwoPrograms f;
    CHECK(run_program_in_double({"check", f.config, "--references", f.given}, f.narrow).code == 0);
    CHECK(run_program_in_double({"plan", f.config, "--references", f.given}, f.narrow).code == 0);
    REQUIRE(f.run_narrow(f.narrow, f.given).code == 0);
    CHECK(contents(f.scratch / "out" / "results.jsonl") == contents(f.scratch / "given" / "results.jsonl"));
    CHECK_THAT(contents(f.scratch / "out" / "results.jsonl"), Catch::Contains("error.position"));
    CHECK(run_program_in_double({"table", f.folder}, f.narrow).code == 0);
    const auto again =
        run_program_in_double({"run", f.config, "-o", f.folder, "--resume", "--references", f.folder}, f.narrow);
    CHECK(again.code == 0);
    CHECK_THAT(again.messages, Catch::Contains("taken over from before"));
    const auto verified = run_program_in_double({"verify", f.folder}, f.narrow);
    CHECK(verified.code == 0);
    CHECK_THAT(verified.out, Catch::Contains("0 differ or are missing") &&
                                 Catch::Contains("1 references are not verified: this program is built without quad"));
}

TEST_CASE("references of other sources do not serve, nor does a folder without them") {
    const TwoPrograms f;
    const auto others = f.run_narrow(BuiltEngine("changed-clang"), f.given);
    CHECK(others.code == usage);
    CHECK_THAT(others.messages, Catch::Contains("/kind: expected metrics without error.*"));
    CHECK(f.run_narrow(f.narrow, (f.scratch / "").string()).code == usage);
    CHECK(f.run_narrow(f.narrow, (f.scratch / "nowhere").string()).code == usage);
    CHECK_FALSE(std::filesystem::exists(f.folder));
}

TEST_CASE("given references are taken before they are computed, whatever the program can") {
    const TwoPrograms f;
    const FakeEngine other;  // whose digest is another, so that it computes
    REQUIRE(run_program({"run", f.config, "-o", f.folder, "--references", f.given}, other).code == 0);
    CHECK(other.references == 1);
    FakeEngine same;
    same.digest = "sources-icc";
    const std::string folder = (f.scratch / "same").string();
    REQUIRE(run_program({"run", f.config, "-o", folder, "--references", f.given}, same).code == 0);
    CHECK(same.references == 0);
}

TEST_CASE("commands that compute in quad say that this program cannot") {
    const ScratchFolder scratch;
    const std::string config = scratch.file("c.json", config_with("metrics", {"defect.*"}));
    for (const std::vector<std::string>& words :
         {std::vector<std::string>{"linearise", config}, {"certify", "rkmk/rk4"}}) {
        const auto result = run_program_in_double(words, plain_engine);
        CHECK(result.code == usage);
        CHECK_THAT(result.messages, Catch::Contains("expected a kreisel with quad precision, got one that is built"));
    }
}

}  // namespace kreisel::double_only
