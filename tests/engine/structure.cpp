// SPDX-License-Identifier: BSD-3-Clause
//
// Geometry of single steps: the two-form and its sign, measured where the answer is known.
#include <catch2/catch.hpp>

#include <cmath>
#include <map>
#include <memory>

#include "engine/run.hpp"
#include "engine/structure/reversal.hpp"
#include "engine/structure/symplecticity.hpp"
#include "engine/structure/volume.hpp"
#include "mechanics/model/scales.hpp"
#include "methods/simulation.hpp"
#include "tests/controls/splitting.hpp"
#include "tests/engine/named_problem.hpp"

using namespace kreisel;
using namespace reference_tests;

namespace {

/// The literature's top at 1/100 of its speed; it starts oblique.
Model slow_top() {
    Model model = standard_model("heavy_top");
    Body& body = model.bodies[0];
    const Vec3 lever(0, 1, 0), omega(1, Real(3) / 2, Real(-1) / 2);
    body.start = {oblique * lever, oblique, oblique * omega.cross(lever), omega};
    return model;
}

/// A simulation and its step, made of `substeps`.
struct Stepped {
    Stepped(const Model& model, const Setup& setup, int substeps = 1)
        : simulation(std::make_unique<Simulation>(model, setup)) {
        step = [&run = *simulation, substeps](const Real& t, const Real& h, Real* state) {
            Status status = run.restart(t, {state, state + run.state().size()});
            for (int i = 0; i < substeps && status == Status::ok; ++i) status = run.step(h / substeps);
            std::copy(run.state().begin(), run.state().end(), state);
            return status;
        };
        y = simulation->state();
    }
    ObservedStep at(const Real& h) const {
        return {simulation->system(), step, extent(simulation->model()), 0, h, y.data()};
    }

    std::unique_ptr<Simulation> simulation;
    Step step;
    std::vector<Real> y;
};

struct SplittingStep {
    SplittingStep(const Model& model, const std::string& formulation, bool stale)
        : system(make_system(model, formulation)),
          method(std::make_unique<SplittingVerlet>(*system, stale)),
          y(initial_state(*system, model)),
          length(extent(model)) {
        step = [&one = *method](const Real& t, const Real& h, Real* state) { return one.step(t, h, state); };
    }
    ObservedStep at(const Real& h) const { return {*system, step, length, 0, h, y.data()}; }

    std::unique_ptr<System> system;
    std::unique_ptr<SplittingVerlet> method;
    std::vector<Real> y;
    Real length;
    Step step;
};

struct StructureCase {
    const char* name;
    Model model;
    const char *formulation, *projection;
};

std::vector<StructureCase> cases() {
    return {{"free top", standard_model("free_top"), "SO3xR3", "none"},
            {"free top", standard_model("free_top"), "SE3", "none"},
            {"heavy top", slow_top(), "SO3", "none"},
            {"heavy top", slow_top(), "S3", "none"},
            {"heavy top", slow_top(), "SE3", "position_velocity"},
            {"double pendulum", standard_model("double_pendulum"), "SO3xR3", "position_velocity"},
            {"double pendulum", standard_model("double_pendulum"), "SE3", "position_velocity"},
            {"double pendulum", standard_model("double_pendulum"), "S3xR3", "position_velocity"},
            {"hinged rods", standard_model("planar_double_pendulum"), "SE3", "position_velocity"},
            {"Bricard's linkage", standard_model("bricard"), "SO3xR3", "position_velocity"}};
}

double slope(const StepDefect& coarse, const StepDefect& fine) {
    REQUIRE(fine.value > 100 * fine.uncertainty);
    return std::log2(to_double(coarse.value / fine.value));
}

}  // namespace

TEST_CASE("a flow preserves the two-form, and no form with the other sign of the bracket", "[structure]") {
    const Real h = Real(1) / 4;
    for (const StructureCase& one : cases()) {
        INFO(one.name << " as " << one.formulation);
        const Setup setup{.formulation = one.formulation, .method = "rkmk/rk4", .projection = one.projection};
        const Stepped flow(one.model, setup, 8), refined(one.model, setup, 16);
        const StepDefect coarse = symplecticity_defect(flow.at(h)), fine = symplecticity_defect(refined.at(h));
        CAPTURE(to_double(coarse.value), to_double(fine.value), to_double(fine.uncertainty), fine.why_not);
        CHECK(fine.value < Real(1) / 1000);
        CHECK(slope(coarse, fine) > 3.7);
        const StepDefect other = symplecticity_defect(refined.at(h), -1);
        CAPTURE(to_double(other.value));
        // A plane motion has parallel rotations, whose brackets vanish.
        if (std::string(one.name) != "hinged rods" && std::string(one.name) != "Bricard's linkage")
            CHECK(other.value > Real(1) / 10);
    }
}

TEST_CASE("a splitting is symplectic and symmetric, with joints too; one with a stale force is neither",
          "[structure]") {
    const std::vector<StructureCase> all = {{"free top", standard_model("free_top"), "SO3xR3", ""},
                                            {"free top", standard_model("free_top"), "S3xR3", ""},
                                            {"heavy top", slow_top(), "SO3", ""},
                                            {"heavy top", slow_top(), "SO3xR3", ""},
                                            {"double pendulum", standard_model("double_pendulum"), "SO3xR3", ""}};
    for (const StructureCase& one : all) {
        const SplittingStep sound(one.model, one.formulation, false), stale(one.model, one.formulation, true);
        const bool turns_the_force =
            std::string(one.formulation) == "SO3";  // elsewhere gravity has constant components
        for (const int n : {10, 20, 40}) {
            const Real h = Real(1) / n;
            INFO(one.name << " as " << one.formulation << ", h = 1/" << n);
            const StepDefect form = symplecticity_defect(sound.at(h)), back = reversal_defect(sound.at(h));
            CAPTURE(to_double(form.value), to_double(form.uncertainty), to_double(back.value));
            CHECK(form.uncertainty < ldexp(Real(1), -70));
            CHECK(form.value <= 10 * form.uncertainty);
            CHECK(back.value <= back.uncertainty);
            const StepDefect broken = symplecticity_defect(stale.at(h));
            CHECK((broken.value > Real(1) / 10000) == turns_the_force);
        }
    }
}

TEST_CASE("defects have the order of the method", "[structure]") {
    const auto slopes = [](const Model& model, const char* formulation, const char* method, auto defect) {
        const Stepped one(model, {.formulation = formulation, .method = method});
        return slope(defect(one.at(Real(1) / 64)), defect(one.at(Real(1) / 128)));
    };
    const auto form = [](const ObservedStep& at) { return symplecticity_defect(at); };
    CHECK(slopes(slow_top(), "SO3", "rkmk/rk4", form) == Approx(5).margin(0.1));
    CHECK(slopes(slow_top(), "SO3", "rkmk/heun", form) == Approx(3).margin(0.1));
    // Symplectic on vector spaces, but its lift to TG is not.
    CHECK(slopes(standard_model("free_top"), "SO3xR3", "rkmk/implicit_midpoint", form) == Approx(3).margin(0.1));
    // Of an even order, the leading errors of a step forth and one back cancel.
    CHECK(slopes(slow_top(), "SO3", "rkmk/rk4", reversal_defect) == Approx(6).margin(0.1));
    CHECK(slopes(slow_top(), "SO3", "rkmk/kutta3", reversal_defect) == Approx(4).margin(0.1));
    const Stepped midpoint(slow_top(), {.formulation = "SO3", .method = "rkmk/implicit_midpoint"});
    const StepDefect back = reversal_defect(midpoint.at(Real(1) / 10));
    CHECK(back.value <= back.uncertainty);
}

TEST_CASE("volume is kept by flows, by what is symplectic, and by what steps on it are functions of its integrals",
          "[structure]") {
    for (const StructureCase& one : cases()) {
        INFO(one.name << " as " << one.formulation);
        const Setup setup{.formulation = one.formulation, .method = "rkmk/rk4", .projection = one.projection};
        const Real h = Real(1) / 4;
        const Stepped flow(one.model, setup, 8), refined(one.model, setup, 16);
        const StepDefect coarse = volume_defect(flow.at(h)), fine = volume_defect(refined.at(h));
        CAPTURE(to_double(coarse.value), to_double(fine.value), to_double(fine.uncertainty));
        CHECK(fine.value < Real(1) / 1000);
        // Not by 16 everywhere: the leading error of the hinged rods all but vanishes.
        CHECK((fine.value <= 10 * fine.uncertainty || 4 * fine.value < coarse.value));
    }
    const auto defect = [](const Model& model, const char* formulation, const char* method, int n) {
        return volume_defect(Stepped(model, {.formulation = formulation, .method = method}).at(Real(1) / n));
    };
    const auto keeps = [&](const Model& model, const char* formulation, const char* method) {
        const StepDefect found = defect(model, formulation, method, 20);
        CAPTURE(method, to_double(found.value), to_double(found.uncertainty));
        CHECK(found.uncertainty < ldexp(Real(1), -60));
        return found.value <= 10 * found.uncertainty;
    };
    CHECK(keeps(slow_top(), "SO3", "splitting/strang"));
    CHECK(keeps(standard_model("double_pendulum"), "SE3", "variational/rattlie"));
    CHECK(keeps(standard_model("free_top"), "SO3xR3", "variational/dmv4"));
    const Stepped dmv(standard_model("free_top"), {.formulation = "SO3xR3", .method = "variational/dmv4"});
    const StepDefect form = symplecticity_defect(dmv.at(Real(1) / 20));
    CHECK(form.value > 1000 * form.uncertainty);
    CHECK_FALSE(keeps(slow_top(), "SO3", "rkmk/rk4"));
    CHECK(slope(defect(slow_top(), "SO3", "rkmk/heun", 64), defect(slow_top(), "SO3", "rkmk/heun", 128)) ==
          Approx(3).margin(0.3));
}

TEST_CASE("where the motion does not preserve the two-form, a step has no such defect", "[structure]") {
    for (const auto& [problem, reason] :
         {std::pair("forced_heavy_top", "no potential"), std::pair("flyball_governor", "dampers"),
          std::pair("rolling_disk", "rolling")}) {
        INFO(problem);
        const Stepped one(standard_model(problem), {.formulation = "SO3xR3"});
        const StepDefect none = symplecticity_defect(one.at(Real(1) / 100));
        CHECK_FALSE(isfinite(none.value));
        CHECK(none.why_not.find(reason) != std::string::npos);
    }
}

namespace {

Outcome run_of(const std::string& problem_name, const std::string& method_name, std::vector<std::string> metrics) {
    const Cell cell{.problem = problem_name,
                    .parameters = demonstration_parameters(problem(problem_name).description),
                    .formulation = "SO3xR3",
                    .method = method_name,
                    .options = with_defaults({}, method(method_name).description.options),
                    .projection = "none",
                    .projection_options = {},
                    .t_end = 1,
                    .steps = 16,
                    .metrics = std::move(metrics)};
    const Outcome outcome = run_cell(cell, nullptr, {});
    REQUIRE(outcome.status == "ok");
    return outcome;
}

std::map<std::string, double> metrics_of(const Outcome& outcome) {
    std::map<std::string, double> all;
    for (const auto& [name, number] : outcome.metrics) all[name] = number.value;
    return all;
}

}  // namespace

TEST_CASE("a run measures its steps, gives what is above the uncertainty, and does not notice", "[structure]") {
    const Outcome rk4 = run_of("free_top", "rkmk/rk4", {"structure.*"}), bare = run_of("free_top", "rkmk/rk4", {});
    const auto found = metrics_of(rk4);
    CHECK(found.size() == 6);
    CHECK(found.at("structure.symplectic") > 1e3 * found.at("structure.symplectic.uncertainty"));
    CHECK(found.at("structure.reversal") > 0);
    CHECK(rk4.unmeasured.empty());
    CHECK(rk4.final->bodies[0].omega[0].text == bare.final->bodies[0].omega[0].text);
    CHECK(rk4.cost.evaluations == bare.cost.evaluations);
    CHECK(rk4.cost.output_evaluations > bare.cost.output_evaluations);
    CHECK(metrics_of(bare).empty());
    const auto midpoint = metrics_of(run_of("free_top", "rkmk/implicit_midpoint", {"structure.reversal*"}));
    CHECK(midpoint.size() == 1);
    CHECK(midpoint.contains("structure.reversal.uncertainty"));
    const Outcome memory = run_of("free_top", "multistep/bliedf2", {"structure.*"});
    CHECK(memory.metrics.empty());
    CHECK(memory.unmeasured.at("structure.reversal") == "a step depends on earlier ones");
    const Outcome forced = run_of("forced_free_body", "rkmk/rk4", {"structure.*"});
    CHECK(forced.unmeasured.size() == 2);
    CHECK(forced.unmeasured.contains("structure.symplectic"));
    CHECK(forced.unmeasured.contains("structure.volume"));
    CHECK(metrics_of(forced).contains("structure.reversal"));
}
