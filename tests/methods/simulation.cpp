// SPDX-License-Identifier: BSD-3-Clause
//
// The front door gives the same results as its parts, and reports failures.
#include "methods/simulation.hpp"

#include "problems/problem.hpp"
#include "tests/methods/linkages.hpp"
#include "tests/methods/stepping.hpp"

using namespace stepping;

namespace {

Model standard_model(const std::string& name) {
    const Problem& entry = problem(name);
    return entry.build(Parameters(default_parameters(entry.description)));
}

}  // namespace

TEST_CASE("a simulation moves a model as its parts do, bit for bit", "[simulation]") {
    const Model model = standard_model("double_pendulum");
    for (const char* name : {"rkmk/rk4", "multistep/bliedf2", "crouch_grossman/cg3a"})
        for (const char* formulation : {"SO3xR3", "SE3"}) {
            INFO(name << " " << formulation);
            const std::string projector = method(name).description.meets_constraints() ? "none" : "position_velocity";
            Simulation simulation(model, {.formulation = formulation, .method = name, .projection = projector});
            std::vector<Real> times;
            REQUIRE(simulation.advance(1, 64, [&](const Simulation& now) { times.push_back(now.time()); }) ==
                    Status::ok);
            REQUIRE(times.size() == 64);
            for (std::size_t i = 0; i < times.size(); ++i) CHECK(times[i] == Real(i + 1) / 64);
            CHECK(simulation.time() == 1);
            Trip parts(model, formulation, method(name), projector);
            REQUIRE(parts.run(1, 64) == Status::ok);
            CHECK(simulation.state() == parts.y);
            CHECK(simulation.bodies()[1].x == parts.bodies()[1].x);
        }
}

TEST_CASE("a simulation that starts again forgets the steps before", "[simulation]") {
    Simulation simulation(standard_model("heavy_top"), {.method = "multistep/bliedf2"});
    const std::vector<Real> start = simulation.state();
    REQUIRE(simulation.advance(Real(1) / 64, 64) == Status::ok);
    const std::vector<Real> end = simulation.state();
    REQUIRE(simulation.restart(0, start) == Status::ok);
    CHECK(simulation.time() == 0);
    REQUIRE(simulation.advance(Real(1) / 64, 64) == Status::ok);
    CHECK(simulation.state() == end);
}

TEST_CASE("a simulation that fails says where, and keeps its time", "[simulation]") {
    Simulation simulation(standard_model("heavy_top"), {});
    CHECK(simulation.advance(2, 8) == Status::left_chart);
    CHECK_THAT(simulation.failure(), Catch::Contains("step of rkmk/rk4: left_chart"));
    CHECK(simulation.time() == 0);
    CHECK_THROWS_AS(Simulation(standard_model("heavy_top"), {.method = "rkmk/rk5"}), std::out_of_range);
    CHECK_THROWS_AS(Simulation(standard_model("heavy_top"), {.options = {{"coordinate", "exp"}}}), OptionError);
}

namespace {

Real spin_error(const Simulation& simulation) {
    return abs(simulation.bodies()[0].omega[2] - simulation.model().bodies[0].start.omega[2]);
}

}  // namespace

TEST_CASE("off the constraints beside a pose where they lose rank a simulation ends, on them it goes on",
          "[simulation]") {
    // A parallelogram at 1 rad/s: all bars lie in a line at pi/2 and 3 pi/2.
    Model model = standard_model("four_bar");
    model.gravity.g.setZero();
    const int t_end = KREISEL_QUAD ? 5 : 16;  // past both, and in double, where drift grows, past three more
    for (const Real& length : {Real(1), Real(1) / 1048576}) {
        if (KREISEL_QUAD && length != 1) continue;  // slow, and the same code
        INFO("lengths times " << length);
        for (const std::string projection : {"none", "position", "velocity"}) {
            if (KREISEL_QUAD && projection != "none") continue;  // drift begins at 1e-34 in all of them
            INFO(projection);
            Simulation off(linkages::in_units(model, length, 1), {.projection = projection});
            const Status status = off.advance(t_end, t_end * 250);
            if (status == Status::ok) {  // in quad, where drift begins at 1e-34
                CHECK(spin_error(off) < Real(1) / 10000);
                continue;
            }
            CHECK(status == Status::singular_kkt);
            CHECK_THAT(off.failure(), Catch::Contains("lose rank") && Catch::Contains("joint "));
        }
        Simulation on(linkages::in_units(model, length, 1), {.projection = "position_velocity"});
        REQUIRE(on.advance(t_end, t_end * 250) == Status::ok);
        CHECK(spin_error(on) < Real(1) / 1000000);
    }
    // An open chain has no such pose, however far it is off.
    Simulation chain(standard_model("double_pendulum"), {});
    CHECK(chain.advance(KREISEL_QUAD ? 1 : 4, KREISEL_QUAD ? 1000 : 4000) == Status::ok);
}
