// SPDX-License-Identifier: BSD-3-Clause
//
// Messages for figures that cannot be drawn from the results, and for a gnuplot that fails.
#include <stdlib.h>

#include <catch2/catch.hpp>
#include <iostream>

#include "plots/figures/gnuplot.hpp"
#include "plots/plot.hpp"
#include "support/errors.hpp"
#include "tests/plots/folder.hpp"

using namespace kreisel;
using namespace kreisel::test;

namespace {

/// What `plot_command` writes to std::cerr, and its exit code.
struct Plotted {
    Exit code;
    std::string messages;
};

Plotted plot(const ResultFolder& folder) {
    const std::ostringstream text;
    std::streambuf* const old = std::cerr.rdbuf(text.rdbuf());
    struct Restore {
        std::streambuf* old;
        ~Restore() { std::cerr.rdbuf(old); }
    } const restore{old};
    const Exit code = plot_command({.folders = {folder.path()}, .figure = {}, .output = {}});
    std::string messages = text.str();
    // The folders written here have no sums.
    const std::string warning = "without check sums: damage cannot be noticed\n";
    const auto end = messages.find(warning);
    return {code, end == std::string::npos ? messages : messages.substr(end + warning.size())};
}

/// Two trajectories that differ in their method, one without R, and cells without samples.
void write_results_into(const ResultFolder& folder) {
    const auto sampled = [](const std::string& cell, const std::string& method) {
        return result_line(cell, 100, 1e-4,
                           {{"method", method},
                            {"trajectory", "trajectories/" + cell + ".csv"},
                            {"metrics", {{"defect.position", 1e-6}}}})
                   .dump() +
               "\n";
    };
    folder.write("results.jsonl", convergence_lines(4, {{"formulation", "SE3"}}) + sampled("aa", "rkmk/rk4") +
                                      sampled("bb", "rkmk/midpoint") + sampled("cc", "cg/cg3a"));
    folder.write("trajectories/aa.csv", trajectory_text());
    folder.write("trajectories/bb.csv", trajectory_text());
    folder.write("trajectories/cc.csv", "t [s],top.x1 [m],top.x2 [m],top.x3 [m]\n0,0,1,0\n1,0,1,0\n");
}

/// The message for one refused figure.
std::string refusal(nlohmann::json figure) {
    const ResultFolder folder;
    write_results_into(folder);
    figure["name"] = "f";
    folder.manifest({{"name", "n"}, {"kind", "convergence"}, {"figure", figure}});
    const Plotted plotted = plot(folder);
    CHECK(plotted.code == Exit::cells_failed);
    CHECK_FALSE(folder.has("figures/f.pdf"));
    return plotted.messages;
}

/// Sets a variable of the environment for as long as it lives.
class Variable {
  public:
    Variable(const char* name, const std::string& value) : name_(name) {
        if (const char* old = getenv(name)) { old_ = old; }
        ::setenv(name, value.c_str(), 1);
    }
    ~Variable() { old_ ? ::setenv(name_, old_->c_str(), 1) : ::unsetenv(name_); }
    Variable(const Variable&) = delete;
    Variable& operator=(const Variable&) = delete;

  private:
    const char* name_;
    std::optional<std::string> old_;
};

}  // namespace

TEST_CASE("a figure that the results cannot fill says what they lack") {
    const nlohmann::json one = {{"method", "rkmk/rk4"}, {"steps", 100}, {"formulation", "SO3xR3"}};
    const nlohmann::json bare = {{"method", "cg/cg3a"}};
    const std::pair<nlohmann::json, std::string> cases[] = {
        {{{"kind", "path3d"}, {"select", {{"steps", 7}}}}, "no cell that is ok fits \"select\""},
        {{{"kind", "convergence"}, {"select", {{"problem", "free_top"}}}}, "no cell that is ok fits \"select\""},
        {{{"kind", "convergence"}, {"select", {{"projection", "terze"}}}}, "no cell that is ok fits \"select\""},
        {{{"kind", "drift"}, {"select", {{"formulation", "SE3"}}}},
         "the selected cells have no samples; set \"output\": {\"samples\": K}"},
        {{{"kind", "components"}}, "3 trajectories fit \"select\", this figure draws one"},
        {{{"kind", "path3d"}, {"select", one}, {"body", "wheel"}}, "the trajectory has no body \"wheel\""},
        {{{"kind", "path3d"}, {"select", bare}}, "the trajectory lacks t, x or R of the body"},
        {{{"kind", "components"}, {"quantity", "omega"}, {"select", bare}},
         "the trajectory has no columns top.omega1, ..."},
        {{{"kind", "components"}, {"quantity", "multipliers"}, {"select", bare}},
         "the trajectory has no columns lambda.JOINT.1, ..."},
        {{{"kind", "motion"}, {"select", one}, {"lever", {0, 0, 0}}}, "f: the lever is zero"},
        {{{"kind", "convergence"}, {"metric", "error.omega"}}, "the selected cells hold no such error"},
        {{{"kind", "drift"}, {"metric", "defect.velocity"}}, "the selected cells hold no such defect"},
        {{{"kind", "invariants"}, {"metric", "invariant.spin"}}, "the selected cells hold no such invariant"},
    };
    for (const auto& [figure, message] : cases) {
        INFO(figure);
        const std::string said = refusal(figure);
        CHECK_THAT(said, Catch::StartsWith("not drawn: "));
        CHECK_THAT(said, Catch::Contains(message));
    }
}

TEST_CASE("a body without a lever is drawn as a top only with one from the figure") {
    const ResultFolder folder;
    folder.write("results.jsonl", result_line("aa", 100, 1e-4,
                                              {{"problem", "free_top"},
                                               {"parameters", {{"lever", nullptr}}},
                                               {"trajectory", "trajectories/aa.csv"}})
                                          .dump() +
                                      "\n");
    folder.write("trajectories/aa.csv", trajectory_text());
    const nlohmann::json figure = {{"kind", "motion"}, {"name", "f"}, {"instants", 1}};
    folder.manifest({{"name", "n"}, {"kind", "trajectory"}, {"figure", figure}});
    const Plotted without = plot(folder);
    CHECK(without.code == Exit::cells_failed);
    CHECK_THAT(without.messages, Catch::Contains("f: problem free_top has no lever; give \"lever\" in the figure"));
    nlohmann::json with = figure;
    with["lever"] = {0, 0, 1};
    folder.manifest({{"name", "n"}, {"kind", "trajectory"}, {"figure", with}});
    CHECK(plot(folder).code == Exit::ok);
    CHECK(folder.has("figures/f.pdf"));
}

TEST_CASE("results without a config, or of a kind without a figure, are not drawn") {
    const ResultFolder folder;
    folder.write("results.jsonl", convergence_lines(4));
    CHECK_THROWS_WITH(plot_command({.folders = {folder.path()}, .figure = {}, .output = {}}),
                      Catch::Contains("no config in it; figures need one"));
    folder.manifest({{"name", "n"}, {"kind", "timing"}});
    const Plotted plotted = plot(folder);
    CHECK(plotted.code == Exit::cells_failed);
    CHECK_THAT(plotted.messages, Catch::Contains("n: no figure shows an experiment of kind timing; describe one"));
}

TEST_CASE("damaged lines are named, and the figure shows the rest") {
    const ResultFolder folder;
    folder.write("results.jsonl", convergence_lines(4) + "{\"cell\"\n");
    folder.manifest({{"name", "n"}, {"kind", "convergence"}});
    const Plotted plotted = plot(folder);
    CHECK(plotted.code == Exit::io);
    CHECK_THAT(plotted.messages, Catch::Contains("results.jsonl:7: "));
    CHECK(folder.has("figures/n.pdf"));
    CHECK_THAT(folder.read("figures/n.svg"), Catch::Contains("damaged results are left out"));
}

TEST_CASE("a gnuplot that is not there, fails or complains is told apart") {
    const ResultFolder folder;
    folder.write("results.jsonl", convergence_lines(4));
    folder.manifest({{"name", "n"}, {"kind", "convergence"}});
    {
        const Variable scripts("KREISEL_PLOTS", folder.path().string());
        CHECK_THROWS_WITH(plot_command({.folders = {folder.path()}, .figure = {}, .output = {}}),
                          Catch::Contains(folder.path().string()) && Catch::Contains("style.gp is missing") &&
                              Catch::Contains("set KREISEL_PLOTS"));
    }
    {
        const Variable path("PATH", folder.path().string());
        CHECK_THROWS_WITH(plot_command({.folders = {folder.path()}, .figure = {}, .output = {}}),
                          Catch::Contains("gnuplot cannot be started: No such file"));
    }
    folder.write("scripts/style.gp", "");
    const Variable scripts("KREISEL_PLOTS", (folder.path() / "scripts").string());
    folder.write("scripts/linespoints.gp", "printerr 'a word'\nexit status 3\n");
    CHECK_THROWS_WITH(plot_command({.folders = {folder.path()}, .figure = {}, .output = {}}),
                      Catch::Contains("gnuplot failed with exit code 3: a word"));
    folder.write("scripts/linespoints.gp", "printerr 'only a warning'\n");
    const Plotted plotted = plot(folder);
    CHECK(plotted.code == Exit::ok);
    CHECK(plotted.messages == "gnuplot on n: only a warning\n\n");
}
