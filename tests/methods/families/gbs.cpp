// SPDX-License-Identifier: BSD-3-Clause
//
// Extrapolation of variable order and step: what it makes of a tolerance, of limits, of springs that turn, of states it
// cannot go on from. (Its single steps: tests/judges/steps/gbs_step.cpp.)
#include <cmath>
#include <limits>

#include "engine/reference/reference.hpp"
#include "mechanics/model/scales.hpp"
#include "methods/simulation.hpp"
#include "tests/mechanics/models/scaled.hpp"
#include "tests/mechanics/models/turning.hpp"
#include "tests/methods/control/controlled_trip.hpp"

using namespace stepping;

namespace {

const Method& gbs() { return method("extrapolation/gbs"); }

ControlledTrip::Bind with_base(const std::string& base) {
    return [base](const Method& entry, System& system, Projection& project, const Accuracy& accuracy) {
        return bind_stepper(entry, system, project, accuracy, {{"base", base}});
    };
}

Accuracy to(const Model& model, const Real& tolerance) { return {.tolerance = tolerance, .length = extent(model)}; }

Real distance_from(const ReferenceSolution& reference, const Model& model, const ControlledTrip& trip) {
    std::vector<BodyState> states(model.bodies.size());
    trip.system->read(trip.y.data(), states.data());
    return worst(distance(states, reference.states));
}

}  // namespace

TEST_CASE("errors of variable order stay within a factor of ten of slope 1", "[gbs]") {
    const Model model = models::standard("forced_heavy_top");
    const ReferenceSolution reference = reference_solution(model, 2);
    for (const char* base : {"group", "chart"}) {
        double least = 1e300, most = 0;
        long coarsest = 0, finest = 0;
        for (int digits = 4; digits <= (KREISEL_QUAD ? 22 : 9); ++digits) {
            const Real tolerance = pow(Real(10), -digits);
            ControlledTrip trip(model, "SO3xR3", gbs(), to(model, tolerance), "none", with_base(base));
            REQUIRE(trip.run(2) == Status::ok);
            const double ratio = to_double(distance_from(reference, model, trip) / tolerance);
            INFO(base << ", " << digits << " digits: error over tolerance " << ratio);
            CHECK(ratio < 1000);
            least = std::min(least, ratio), most = std::max(most, ratio);
            finest = trip.stepper->accepted();
            if (coarsest == 0) coarsest = finest;
        }
        CHECK(most <= 100 * least);
        CHECK(finest <=
              4 * coarsest);  // the order rises: with a fixed one of 8, five digits more take four times the steps
    }
}

TEST_CASE("a run of variable order depends on its start only", "[gbs]") {
    const Model model = models::standard("double_pendulum");
    ControlledTrip trip(model, "SO3xR3", gbs(), to(model, Real(1) / 1000000));
    const std::vector<Real> start = trip.y;
    REQUIRE(trip.run(1) == Status::ok);
    const std::vector<Real> end = trip.y;
    trip.y = start;
    REQUIRE(trip.run(1) == Status::ok);
    CHECK(trip.y == end);

    Real t = 1;
    REQUIRE(trip.stepper->start(t, 0, trip.y.data()) == Status::ok);
    while (t > 0) REQUIRE(trip.stepper->step(t, 0, trip.y.data()) == Status::ok);
    CHECK(t == 0);
    for (std::size_t i = 0; i < start.size(); ++i) CHECK(abs(trip.y[i] - start[i]) < Real(1) / 1000);
}

TEST_CASE("limits are met, and what they cut short is not taken for the size of steps", "[gbs]") {
    const Model model = models::standard("forced_heavy_top");
    ControlledTrip free(model, "SO3xR3", gbs(), to(model, Real(1) / 100000000)),
        cut = ControlledTrip(model, "SO3xR3", gbs(), to(model, Real(1) / 100000000));
    REQUIRE(free.run(4) == Status::ok);
    Real t = 0;
    REQUIRE(cut.stepper->start(t, 4, cut.y.data()) == Status::ok);
    for (int i = 1; i <= 4; ++i) {
        while (t < i) REQUIRE(cut.stepper->step(t, i, cut.y.data()) == Status::ok);
        CHECK(t == i);
    }
    CHECK(cut.stepper->accepted() <= free.stepper->accepted() + 8);
    for (std::size_t i = 0; i < free.y.size(); ++i) CHECK(abs(cut.y[i] - free.y[i]) < Real(1) / 100000);
}

TEST_CASE("projected steps of variable order end on the constraints", "[gbs]") {
    const Model model = models::standard("double_pendulum");
    ControlledTrip trip(model, "SO3xR3", gbs(), to(model, Real(1) / 1000000), "position_velocity");
    REQUIRE(trip.run(1) == Status::ok);
    VecX rows(trip.system->constraints());
    trip.system->position_residual(1, trip.y.data(), rows.data());
    CHECK(rows.norm() < 100 * epsilon);
}

TEST_CASE("springs turn in steps of variable order", "[gbs]") {
    const models::Turner turner = models::wheel("revolute", 30);
    for (const char* base : {"group", "chart"}) {
        ControlledTrip trip(turner.model, "SE3", gbs(), to(turner.model, Real(1) / 1000000), "none", with_base(base));
        REQUIRE(trip.run(1) == Status::ok);
        SpringAngle angle;
        trip.system->read_angles(trip.y.data(), &angle);
        CHECK(abs(angle.theta - turner.exact(1).first) < Real(1) / 1000);
        CHECK(abs(angle.turns) >= 2);
    }
}

TEST_CASE("units that are powers of two change no bit of steps of variable order", "[gbs]") {
    const Model model = models::standard("double_pendulum");
    const auto run = [&](const Model& scaled, const Real& t_end) {
        Simulation simulation(
            scaled,
            {.method = "extrapolation/gbs", .projection = "position_velocity", .tolerance = Real(1) / 10000000});
        CHECK(simulation.advance(t_end) == Status::ok);
        return std::pair(simulation.stepper()->accepted(), simulation.bodies());
    };
    const Real t_end = Real(1) / 2;
    const auto [steps, bodies] = run(model, t_end);
    for (const models::Units& units : models::other_units()) {
        const auto [scaled_steps, scaled_bodies] = run(models::scaled(model, units), t_end * units.T());
        CHECK(scaled_steps == steps);
        CHECK(scaled_bodies[1].x == bodies[1].x * units.L());
        CHECK(scaled_bodies[1].R == bodies[1].R);
    }
}

TEST_CASE("steps of variable order that cannot go on say why", "[gbs]") {
    const Model top = models::standard("heavy_top");
    Simulation careless(top, {.method = "extrapolation/gbs", .options = {{"base", "chart"}}, .tolerance = 50});
    CHECK(careless.advance(Real(1) / 2) == Status::ok);  // the first steps leave their chart, and are rejected
    CHECK(careless.stepper()->rejected() > 0);

    Model breaking = models::standard("forced_heavy_top");
    breaking.gravity.amplitude = std::numeric_limits<Real>::infinity();
    Simulation broken(breaking, {.method = "extrapolation/gbs", .tolerance = Real(1) / 1000000});
    CHECK(broken.advance(1) == Status::non_finite);
    CHECK(broken.time() == 0);
}
