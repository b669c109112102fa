// SPDX-License-Identifier: BSD-3-Clause
//
// kreisel doctor: what it finds on a PATH of our own, in folders that cannot be written, and of engines that err.
#include <catch2/catch.hpp>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "driver/cli/doctor/tools.hpp"
#include "support/errors.hpp"
#include "tests/driver/command_line.hpp"
#include "tests/driver/other_engine.hpp"

using namespace kreisel;

namespace {

/// Has the problem of the self-test, on which rkmk/rk4 shows some order; its reference is certain to some length (m).
class MeasuredEngine : public OtherEngine {
  public:
    explicit MeasuredEngine(double order, double certain_to = 1e-25) : order_(order), certain_to_(certain_to) {}
    std::vector<ProblemDescription> problems() const override {
        auto all = OtherEngine::problems();
        all.push_back({.name = "lagrange_top"});
        return all;
    }
    Outcome run(const Cell& cell, const Reference*, const Watch&, SampleSink*) const override {
        Outcome outcome;
        const double error = std::pow(static_cast<double>(cell.steps), -order_);
        outcome.metrics = {{"error.position", {error, ""}}};
        outcome.final = ReportedState();
        return outcome;
    }
    Reference reference(const std::string&, const ParameterValues&, const BeginState*, double, long,
                        const Watch&) const override {
        return {.state = {}, .error = {{"error.position", {certain_to_, ""}}}, .horizon = 1};
    }

  private:
    double order_, certain_to_;
};

/// A PATH with nothing but programs of our own.
class OwnPath {
  public:
    OwnPath() : old_(std::getenv("PATH")) { ::setenv("PATH", (scratch_ / "").c_str(), 1); }
    ~OwnPath() { ::setenv("PATH", old_.c_str(), 1); }
    OwnPath(const OwnPath&) = delete;
    OwnPath& operator=(const OwnPath&) = delete;
    void add(const std::string& name, const std::string& script) const {
        const std::string file = scratch_.file(name, "#!/bin/sh\n" + script + "\n");
        std::filesystem::permissions(file, std::filesystem::perms::owner_all);
    }

  private:
    ScratchFolder scratch_;
    std::string old_;
};

ProgramResult examine(const std::filesystem::path& folder, const Engine& engine = MeasuredEngine(4)) {
    return run_program({"doctor", "-o", folder.string()}, engine);
}

std::string line_about(const std::string& text, const std::string& topic) {
    const std::size_t at = text.find(topic + " ");
    if (at == std::string::npos) { return ""; }
    const std::size_t begin = text.rfind('\n', at) + 1;
    return text.substr(begin, text.find('\n', at) - begin);
}

}  // namespace

TEST_CASE("what is not on the path is missing, with the command that installs it, and that is not a failure") {
    const ScratchFolder scratch;
    const OwnPath path;
    const ProgramResult result = examine(scratch / "results");
    INFO(result.out);
    CHECK(result.code == 0);
    CHECK(line_about(result.out, "gnuplot").starts_with("missing"));
    CHECK(line_about(result.out, "gnuplot").find("tools/setup figures") != std::string::npos);
    CHECK(line_about(result.out, "LaTeX").find("tools/setup paper") != std::string::npos);
    CHECK(line_about(result.out, "Valgrind").find("tools/setup maintain") != std::string::npos);
    CHECK_FALSE(std::filesystem::exists(scratch / "results"));
}

TEST_CASE("versions are shown; a broken program is a failure, and Python without pandas is not") {
    const ScratchFolder scratch;
    const OwnPath path;
    path.add("gnuplot", "echo 'gnuplot 5.4 patchlevel 4'");
    path.add("python3", "echo 'ModuleNotFoundError: No module named pandas' >&2; exit 1");
    const ProgramResult good = examine(scratch / "");
    INFO(good.out);
    CHECK(good.code == 0);
    CHECK(line_about(good.out, "gnuplot").find("gnuplot 5.4 patchlevel 4") != std::string::npos);
    CHECK(line_about(good.out, "Python, pandas").starts_with("missing"));
    path.add("gnuplot", "echo 'cannot load libreadline' >&2; exit 127");
    CHECK(line_about(examine(scratch / "").out, "gnuplot").starts_with("failed"));
    path.add("gnuplot", "echo 'undefined symbol: x' >&2; exit 3");
    const ProgramResult broken = examine(scratch / "");
    CHECK(broken.code == static_cast<int>(Exit::cells_failed));
    CHECK(line_about(broken.out, "gnuplot").find("exit code 3, and it said \"undefined symbol: x\"") !=
          std::string::npos);
}

TEST_CASE("what does not end is ended, and has failed, whether it still writes or not") {
    const OwnPath path;
    path.add("gnuplot", "while :; do :; done");
    path.add("pdflatex", "echo 'pdfTeX 3'; exec >&- 2>&-; while :; do :; done");
    path.add("valgrind", "printf 'valgrind\\033[2J-3\\n'");
    const auto findings = find_tools(std::chrono::milliseconds(300));
    CHECK(findings.at(0).health == Health::failed);
    CHECK(findings.at(0).found == "no answer within 0.3 s");
    CHECK(findings.at(1).health == Health::failed);
    CHECK(findings.at(5).found == "valgrind[2J-3");
}

TEST_CASE("a folder that cannot be written is a failure") {
    const OwnPath path;
    const ProgramResult result = examine("/proc/kreisel/results");
    INFO(result.out);
    CHECK(result.code == static_cast<int>(Exit::cells_failed));
    CHECK(line_about(result.out, "results").starts_with("failed"));
    CHECK(line_about(result.out, "results").find("another folder with -o") != std::string::npos);
}

TEST_CASE("the self-test holds observed orders against the declared one, and the reference against its certainty") {
    const ScratchFolder scratch;
    const OwnPath path;
    CHECK(examine(scratch / "").code == 0);
    for (const double order : {2.0, 3.8, 4.2}) {
        const ProgramResult result = examine(scratch / "", MeasuredEngine(order));
        INFO(result.out);
        CHECK(result.code == static_cast<int>(Exit::cells_failed));
        CHECK(line_about(result.out, "self-test: quad").starts_with("failed"));
    }
    const ProgramResult vague = examine(scratch / "", MeasuredEngine(4, 1e-12));
    CHECK(vague.code == static_cast<int>(Exit::cells_failed));
    CHECK(line_about(vague.out, "self-test: reference").starts_with("failed"));
    CHECK(examine(scratch / "", FakeEngine()).out.find("there is no problem lagrange_top") != std::string::npos);
}

TEST_CASE("without quad precision the self-test holds double against finer steps, and says what is missing") {
    const ScratchFolder scratch;
    const OwnPath path;
    const auto examined = [&](double order) {
        return run_program_in_double({"doctor", "-o", (scratch / "").string()}, MeasuredEngine(order));
    };
    const ProgramResult good = examined(4);
    INFO(good.out);
    CHECK(good.code == 0);
    CHECK(line_about(good.out, "self-test: quad").starts_with("missing"));
    CHECK(line_about(good.out, "self-test: double").find("observed orders 4.00, 4.00") != std::string::npos);
    CHECK(examined(3).code == static_cast<int>(Exit::cells_failed));
}

TEST_CASE("the same as JSON") {
    const ScratchFolder scratch;
    const OwnPath path;
    const ProgramResult result = run_program({"doctor", "--json", "-o", (scratch / "").string()}, MeasuredEngine(4));
    const auto list = nlohmann::json::parse(result.out);
    CHECK(list.size() == 15);
    for (const auto& finding : list) {
        CHECK(finding.at("topic").get<std::string>().size() > 4);
        CHECK(finding.at("found").get<std::string>().size() > 0);
        CHECK((finding.at("state") == "ok") == finding.at("advice").get<std::string>().empty());
    }
}
