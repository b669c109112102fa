// SPDX-License-Identifier: BSD-3-Clause
//
// Configs that come with kreisel: what they are called, and that they are found by name.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "driver/config/shipped.hpp"
#include "kreisel_build.hpp"
#include "plots/figures/kind.hpp"
#include "records/kinds/kind.hpp"
#include "support/errors.hpp"
#include "support/pattern.hpp"
#include "tests/driver/command_line.hpp"

using namespace kreisel;
using nlohmann::literals::operator""_json_pointer;

namespace {

/// Lets a folder stand for the shipped configs for as long as it lives.
class ShippedFrom {
  public:
    explicit ShippedFrom(const std::filesystem::path& folder) { ::setenv("KREISEL_EXPERIMENTS", folder.c_str(), 1); }
    ~ShippedFrom() { ::unsetenv("KREISEL_EXPERIMENTS"); }
    ShippedFrom(const ShippedFrom&) = delete;
    ShippedFrom& operator=(const ShippedFrom&) = delete;
};

/// A folder of configs with folders in it.
struct Experiments {
    ScratchFolder scratch;
    Experiments() {
        for (const auto* folder : {"orders", "drift"}) { std::filesystem::create_directory(scratch / folder); }
        scratch.file("orders/good.json", good_config());
    }
};

}  // namespace

TEST_CASE("every shipped config is called as its file and says what it shows") {
    const auto shipped = configs_below(std::filesystem::path(build::source_dir) / "experiments");
    CHECK(shipped.size() > 10);
    for (const auto& [name, file] : shipped) {
        INFO(file);
        const auto config = nlohmann::json::parse(contents(file));
        CHECK(config.at("name") == name);
        CHECK(config.value("description", "").size() > 20);
    }
}

TEST_CASE("a shipped config has the metrics and samples that its figure draws, or names its figures") {
    // ./reproduce draws them all. Of several trajectories, the figure of one has to be told which.
    for (const auto& [name, file] : configs_below(std::filesystem::path(build::source_dir) / "experiments")) {
        INFO(file);
        const auto config = nlohmann::json::parse(contents(file));
        if (config.contains("figure")) { continue; }
        const ExperimentKind& kind = *find_experiment_kind(config.at("kind").get<std::string>());
        CHECK(kind.name != "trajectory");
        const FigureKind& figure = *find_figure_kind(kind.figure);
        const auto measured = config.value("metrics", kind.metrics);
        for (const std::string& metric : figure.make()->drawn_metrics()) {
            CHECK((kind.timed || matches_any(measured, metric)));
        }
        if (figure.draws != FigureData::samples) { continue; }
        CHECK(config.value("/output/samples"_json_pointer, 0) > 0);
    }
}

TEST_CASE("two shipped configs of one name are refused") {
    const Experiments experiments;
    CHECK(configs_below(experiments.scratch / "").size() == 1);
    experiments.scratch.file("drift/good.json", good_config());
    CHECK_THROWS_WITH(configs_below(experiments.scratch / ""), Catch::Contains("expected one config of each name") &&
                                                                   Catch::Contains("orders/good.json") &&
                                                                   Catch::Contains("drift/good.json"));
}

TEST_CASE("a config is found by its name, and a file comes first") {
    const Experiments experiments;
    const ShippedFrom folder(experiments.scratch / "");
    CHECK(config_file("good") == experiments.scratch / "orders/good.json");
    CHECK(run_program({"check", "good"}).out.find("orders/good.json: good; ") != std::string::npos);
    CHECK(run_program({"plan", "good"}).code == 0);
    const auto own = experiments.scratch.file("own.json", good_config());
    CHECK(config_file(own) == own);
    const auto out = (experiments.scratch / "out").string();
    CHECK(run_program({"run", "good", "-o", out}).code == 0);
    CHECK(std::filesystem::exists(experiments.scratch / "out/results.csv"));
}

TEST_CASE("a name that no config has is told with the nearest one") {
    const Experiments experiments;
    const ShippedFrom folder(experiments.scratch / "");
    const ProgramResult name = run_program({"run", "goood", "gud"});
    CHECK(name.code == static_cast<int>(Exit::usage));
    CHECK_THAT(name.messages, Catch::Contains("got \"goood\"; did you mean \"good\"?") &&
                                  Catch::Contains("the name of a config in " + (experiments.scratch / "").string()) &&
                                  Catch::Contains("\"gud\""));
    const ProgramResult path = run_program({"check", "experiments/good.json"});
    CHECK(path.code == static_cast<int>(Exit::io));
    CHECK_THAT(path.messages, Catch::Contains("experiments/good.json: there is no such file; did you mean \"good\"?"));
}
