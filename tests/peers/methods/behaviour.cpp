// SPDX-License-Identifier: BSD-3-Clause
//
// What every baseline with a control of its own must do, whatever its library.
#include <fstream>

#include "kreisel_build.hpp"
#include "tests/peers/methods/approach.hpp"

using namespace kreisel;
using namespace peers;

namespace {

const Real tenth = Real(1) / 10, tolerance = Real(1) / 1000000;

template <class F>
void for_each_run(F f) {
    for (const Method& entry : baselines())
        for (const OptionValues& options : variants(entry))
            for (const auto& [problem, formulation] :
                 {std::pair("forced_heavy_top", "SO3"), std::pair("double_pendulum", "SO3xR3")}) {
                INFO(entry.description.name << text(options) << " on " << problem << " as " << formulation);
                f(problem, Approach(models::standard(problem), formulation, entry, options, tolerance));
            }
}

}  // namespace

TEST_CASE("limits are met exactly, and not passed", "[peers]") {
    for_each_run([](const std::string& problem, Approach run) {
        CHECK(run.run({3 * tenth, 3 * tenth + tenth / 1000, 7 * tenth, 1}) == Status::ok);
        CHECK(run.t == 1);
        CHECK(to_double(error_at_1(problem, run)) < 1e-3);
    });
}

TEST_CASE("a run repeats to the last bit, and start forgets what was before", "[peers]") {
    for_each_run([](const std::string&, Approach run) {
        const std::vector<Real> start = run.y;
        CHECK(run.run({tenth, 1}) == Status::ok);
        const std::vector<Real> end = run.y;
        run.y = start, run.t = 0;
        CHECK(run.run({3 * tenth}) == Status::ok);
        run.y = start, run.t = 0;
        CHECK(run.run({tenth, 1}) == Status::ok);
        CHECK(run.y == end);
    });
}

TEST_CASE("time runs backwards too", "[peers]") {
    for_each_run([](const std::string&, Approach run) {
        const std::vector<Real> start = run.y;
        CHECK(run.run({-tenth}) == Status::ok);
        run.begin = -tenth;
        CHECK(run.run({0}) == Status::ok);
        Real apart = 0;
        for (std::size_t i = 0; i < start.size(); ++i) apart = max(apart, Real(abs(run.y[i] - start[i])));
        CHECK(to_double(apart) < 1e-3);
        CHECK(apart > 0);
    });
}

TEST_CASE("steps are counted, and rotations stay rotations", "[peers]") {
    for_each_run([](const std::string&, Approach run) {
        CHECK(run.run({1}) == Status::ok);
        CHECK(run.stepper->accepted() > 3);
        CHECK(run.stepper->rejected() >= 0);
        CHECK(run.system->evaluations() > run.stepper->accepted());
        CHECK(run.system->group().orthogonality_defect(run.y.data()) <= 100 * epsilon);
    });
}

TEST_CASE("a projection keeps the constraints of baselines that take one, at their tolerance", "[peers]") {
    for (const Method& entry : baselines()) {
        if (!entry.description.projectable) continue;
        for (const OptionValues& options : variants(entry)) {
            INFO(entry.description.name << text(options));
            const Model model = models::standard("double_pendulum");
            Approach run(model, "SO3xR3", entry, options, tolerance, "position_velocity"),
                free(model, "SO3xR3", entry, options, tolerance);
            const auto defect = [](const Approach& end) {
                VecX rows(end.system->constraints());
                end.system->position_residual(0, end.y.data(), rows.data());
                return rows.norm();
            };
            REQUIRE(run.run({1}) == Status::ok);
            REQUIRE(free.run({1}) == Status::ok);
            CHECK(defect(run) <= 100 * epsilon);
            CHECK(defect(free) > 1000 * epsilon);
            CHECK(to_double(error_at_1("double_pendulum", run)) < 1e-3);
        }
    }
}

TEST_CASE("baselines of other libraries describe themselves", "[peers]") {
    const std::string root = build::source_dir;
    for (const Method& entry : methods()) {
        const MethodDescription& description = entry.description;
        if (!description.own_control || !description.name.starts_with("baseline/")) continue;
        const std::string name = description.name.substr(description.name.find('/') + 1);
        const std::string file = "peers/" + name.substr(0, name.find('_')) + "/" + name + ".cpp";
        INFO(description.name << " in " << entry.file);
        CHECK(entry.file.ends_with("/" + file));
        CHECK(std::ifstream(root + "/" + file).good());
        CHECK_FALSE(description.summary.empty());
        CHECK_FALSE(description.cites.empty());
        // One that does not run in this precision says so.
        const std::string reason = entry.factory.why_not(stepping::default_options(description.options));
        CHECK(static_cast<bool>(entry.factory.stepper) == reason.empty());
        CHECK((KREISEL_QUAD || reason.empty()));
    }
}
