// SPDX-License-Identifier: BSD-3-Clause
//
// Torsion springs through several turns, by every method in every formulation, against closed forms; and steps that
// cannot resolve the turns of a spring, which must report it.
#include "mechanics/start.hpp"
#include "tests/mechanics/models/turning.hpp"
#include "tests/methods/stepping.hpp"

using namespace kreisel;
using namespace models;
using namespace stepping;

namespace {

using Catch::Contains;

std::vector<std::string> formulations_of(const Method& entry, const Model& model) {
    std::vector<std::string> names;
    for (const std::string& name : applicable(model))
        if (runs_on(entry, model, name)) names.push_back(name);
    return names;
}

SpringAngle angle_of(const Trip& trip) {
    std::vector<SpringAngle> angles(static_cast<std::size_t>(trip.system->torsion_springs()));
    trip.system->read_angles(trip.y.data(), angles.data());
    return angles.at(0);
}

/// Distances of theta and theta' from the closed form at the end.
struct Miss {
    Status status;
    Real theta, rate;
};
Miss miss(const Turner& turner, Trip& trip, const Real& t_end, long steps) {
    const Status status = trip.run(t_end, steps);
    const auto [theta, rate] = turner.exact(t_end);
    return {status, abs(angle_of(trip).theta - theta), abs(turner.rate(trip.bodies()) - rate)};
}

/// Above any admissible error of a method: a lost turn is an error of 2 pi.
const Real wrong = 3;

/// The objection to a method that is bound to a system by `bind`, or "".
template <class Bind>
std::string turning_objection(const Turner& turner, const std::string& form, const Order& order, const Real& t_end,
                              long steps, const Method& entry, Bind bind) {
    Miss misses[2];
    for (const int level : {0, 1}) {
        Trip trip(turner.model, form, entry);
        trip.integrator = bind(*trip.system);
        misses[level] = miss(turner, trip, t_end, level == 0 ? steps : 2 * steps);
        if (misses[level].status != Status::ok)
            return name(misses[level].status) + (": " + trip.system->reason(Status::turn_lost));
        if (!(misses[level].theta < wrong)) return "the angle misses by " + to_text(misses[level].theta);
    }
    // Each error by itself passes through zero at times; the distance in the plane of theta and theta'/w does not.
    const Real w = sqrt(turner.exact.k / turner.exact.J);
    const auto error = [&](const Miss& m) { return Real(sqrt(m.theta * m.theta + m.rate * m.rate / (w * w))); };
    const Real coarse = error(misses[0]), fine = error(misses[1]), floor = 100000 * epsilon;
    const int declared = std::min(order.configuration, order.velocity);
    if (fine > floor && log2(coarse / fine) < Real(declared) - Real(1) / 4)
        return "order " + to_text(log2(coarse / fine)) + ", errors " + to_text(coarse) + " and " + to_text(fine);
    return "";
}

std::string turning_objection(const Turner& turner, const std::string& form, const Method& entry, const Real& t_end,
                              long steps) {
    const OptionValues options = default_options(entry.description.options);
    return turning_objection(turner, form, entry.factory.order(options, entry.description.order), t_end, steps, entry,
                             [&](System& system) { return entry.bind(system, options); });
}

/// A first-order method needs short steps before its order shows. So does BLieDF on SO3xR3: at 30 rad/s its errors are
/// 0.24, 0.078, 0.022, 0.0058 and 0.0015 from 128 steps on, orders 1.61, 1.82, 1.92, 1.96.
/// The errors of half-explicit methods change their sign on the moving pair: those of herk3 fall with the orders 0.96,
/// 2.49, 2.79 and 2.90 from 512 steps on.
long steps_for(const Method& entry, long steps) {
    if (entry.description.order.configuration == 1) return 16 * steps;
    if (entry.description.form == Form::half_explicit) return 32 * steps;
    return entry.description.reports_multipliers ? 4 * steps : steps;
}

Model with_torque(Model model, const Real& torque) {
    model.loads.push_back({.body = 0, .torque = Vec3(0, 0, torque)});
    return model;
}

/// The standard options but for coordinates that reach any angle: differences of rotation matrices end at pi/2.
OptionValues far_reaching(const Method& entry) {
    OptionValues options = default_options(entry.description.options);
    if (options.contains("coordinates")) options["coordinates"] = std::string("exp");
    return options;
}

}  // namespace

TEST_CASE("springs through several turns follow their closed forms, by every method in every formulation", "[turns]") {
    if (KREISEL_QUAD) return;  // slow, and the same code
    const Turner turners[] = {wheel("revolute", 10),
                              wheel("spherical", 0, 20),
                              wheel("revolute", -30, 1),
                              crooked(30, Real(1)),
                              crooked(-25, pi() - Real(1) / 1000000),
                              moving_pair(25)};
    for (const Turner& turner : turners) {
        for (const Method& entry : methods())
            for (const std::string& form : formulations_of(entry, turner.model)) {
                if (!entry.description.equivariant && turner.name != "wheel") continue;  // may meet its singularity
                INFO(entry.description.name << " on " << form << ": " << turner.name << ", " << turner.exact.rate);
                CHECK(turning_objection(turner, form, entry, 1, steps_for(entry, 128)) == "");
            }
    }
}

TEST_CASE("a spring that loses its turns is rejected", "[turns]") {
    for (const char* name : {"rkmk/rk4", "crouch_grossman/cg3a", "generalized_alpha/index2", "baseline/rk4_matrix"}) {
        const Method& entry = method(name);
        const OptionValues options = default_options(entry.description.options);
        // Without the bracket of begin_step and end_step labels are not updated: it works only up to half a turn.
        const auto forgetful = [&](System& system) { return entry.factory.make(system, options, entry.description); };
        CHECK(turning_objection(wheel("revolute", 10), "SO3xR3", entry.description.order, 1, 64, entry, forgetful) !=
              "");
        CHECK(turning_objection(wheel("revolute", 0, 20), "SO3xR3", entry.description.order, 1, 64, entry, forgetful) !=
              "");
    }
}

TEST_CASE("turns at the start count, and a run goes on from what it reported", "[turns]") {
    const Turner three = wheel("revolute", 0, 0, 3);
    for (const char* name : {"rkmk/rk4", "multistep/bliedf2"}) {
        Trip trip(three.model, "SE3", method(name));
        CHECK(angle_of(trip).turns == 3);
        CHECK(abs(angle_of(trip).theta - 6 * pi()) <= 16 * epsilon);
        CHECK(miss(three, trip, 1, 1024).theta < Real(1) / 1000);
    }
    const Turner turner = wheel("revolute", 10, 20, -2);
    Trip whole(turner.model, "SO3xR3", method("rkmk/rk4"));
    REQUIRE(whole.run(1, 64) == Status::ok);
    Model stopped = turner.model;
    stopped.bodies[0].start = whole.bodies()[0];
    stopped.torsion_springs[0].turns = angle_of(whole).turns;
    Trip rest(stopped, "SO3xR3", method("rkmk/rk4"));
    REQUIRE(whole.run(1, 64) == Status::ok);
    REQUIRE(rest.run(1, 64) == Status::ok);
    CHECK(rest.y == whole.y);
    CHECK(angle_of(rest).turns != turner.model.torsion_springs[0].turns);
}

TEST_CASE("the angle is continuous where a pose passes half a turn", "[turns]") {
    Turner turner = wheel("revolute", 0);
    const auto system = make_system(turner.model, "S3xR3");
    std::vector<Real> y = initial_state(*system, turner.model);
    SpringAngle angle;
    BodyState state = turner.model.bodies[0].start;
    for (int i = 0; i <= 60; ++i) {  // labels follow by steps of 0.3 rad, as projections and steps leave them
        const Real theta = Real(3 * i) / 10;
        state.R = SO3::exp(Vec3(0, 0, theta));
        system->write(&state, y.data());
        system->read_angles(y.data(), &angle);
        CHECK(abs(angle.theta - theta) <= 64 * epsilon);
        CHECK(abs(system->potential(0, y.data()) - 2 * theta * theta) <= 4096 * epsilon);
        *system->labels(y.data()) = angle.theta;
    }
    CHECK(angle.turns == 3);
    for (const Real& side : {Real(-1), Real(1)}) {  // a projection that moves a pose over the cut and back
        const Real near = side / 1000000;
        state.R = SO3::exp(Vec3(0, 0, pi() + near));
        system->write(&state, y.data());
        *system->labels(y.data()) = pi() - near;
        system->read_angles(y.data(), &angle);
        CHECK(abs(angle.theta - pi() - near) <= 64 * epsilon);
    }
}

TEST_CASE("projections and restarts keep the turns", "[turns]") {
    if (KREISEL_QUAD) return;  // slow, and the same code
    const Turner turner = crooked(30, 3);
    for (const char* projector : {"position", "position_velocity", "velocity"})
        for (const char* form : {"SO3xR3", "SE3", "S3xR3"}) {
            Trip trip(turner.model, form, method("rkmk/rk4"), projector);
            CHECK(miss(turner, trip, 1, 256).theta < Real(1) / 10000);
        }
    // The seed's projection, for spherical joints only.
    const Turner ball = wheel("spherical", 10, 20);
    Trip seed(ball.model, "SO3xR3", method("rkmk/rk4"), "terze");
    CHECK(miss(ball, seed, 1, 256).theta < Real(1) / 10000);
    for (const char* name : {"multistep/bliedf2", "generalized_alpha/index2"}) {
        Trip trip(turner.model, "SE3", method(name));
        const Real h = Real(1) / 2048;
        Status status = Status::ok;
        for (int i = 0; i < 2048 && status == Status::ok; ++i) {
            if (i % 256 == 0) REQUIRE(trip.integrator->start(h * i, trip.y.data()) == Status::ok);
            status = trip.integrator->step(h * i, h, trip.y.data());
        }
        CHECK(status == Status::ok);
        CHECK(abs(angle_of(trip).theta - turner.exact(1).first) < Real(1) / 1000);
    }
}

TEST_CASE("a wheel may turn by almost half a turn in a step, and not by more", "[turns]") {
    Turner turner = wheel("spherical", 10);
    turner.model.torsion_springs[0].stiffness = Real(1) / 1000000;
    for (const char* name : {"rkmk/rk4", "rkmk/euler", "crouch_grossman/cg4a", "rkmk/implicit_midpoint"})
        for (const std::string& form : formulations_of(method(name), turner.model)) {
            INFO(name << " on " << form);
            Trip below(turner.model, form, method(name));
            REQUIRE(below.run(31, 100) == Status::ok);  // 3.1 rad each
            CHECK(angle_of(below).turns == 49);
            CHECK(abs(angle_of(below).theta - 310) < 1);
            Trip above(turner.model, form, method(name));
            const std::vector<Real> y = above.y;
            CHECK(above.run(32, 100) == Status::turn_lost);  // 3.2 rad
            CHECK(above.y == y);
            CHECK_THAT(above.system->reason(Status::turn_lost),
                       Contains("torsion spring 0 (ground - wheel) turns by 3.2 rad in a step"));
        }
}

TEST_CASE("an angle far from where the step began to lead is lost, and the state stays", "[turns]") {
    // 31 rad/s decelerated by about 400 rad/s^2 within 0.1 s: no stage turns by pi, but the end lies 2 rad behind.
    const Turner turner = wheel("spherical", 31);
    const Model model = with_torque(turner.model, -400);
    for (const Method& entry : methods())
        for (const std::string& form : formulations_of(entry, model)) {
            if (entry.description.order.configuration == 1) continue;  // extrapolates the start of the step
            if (!entry.description.equivariant) continue;  // reports that its coordinates cannot rotate so far
            INFO(entry.description.name << " on " << form);
            const OptionValues options = far_reaching(entry);
            Trip trip(model, form, entry, options);
            REQUIRE(trip.integrator->start(0, trip.y.data()) == Status::ok);
            const std::vector<Real> y = trip.y;
            CHECK(trip.integrator->step(0, Real(1) / 10, trip.y.data()) == Status::turn_lost);
            CHECK(trip.y == y);
            CHECK_THAT(trip.system->reason(Status::turn_lost), Contains("torsion spring 0 (ground - wheel)"));
            // The failed step has left no trace.
            Trip fresh(model, form, entry, options);
            for (Trip* one : {&trip, &fresh}) CHECK(one->run(Real(1) / 100, 10) == Status::ok);
            CHECK(trip.y == fresh.y);
        }
}

TEST_CASE("axes that part have no turns to count", "[turns]") {
    Turner turner = wheel("spherical", 0);
    Model& model = turner.model;
    model.torsion_springs[0].stiffness = Real(1) / 1024;
    model.bodies[0].start.omega = Vec3(0, 2, 0);  // tips the first axis out of the plane: 60 degrees at t = pi/6
    for (const char* name : {"rkmk/rk4", "crouch_grossman/cg2", "rkmk/implicit_midpoint", "generalized_alpha/index2"})
        for (const std::string& form : formulations_of(method(name), model)) {
            INFO(name << " on " << form);
            Trip before(model, form, method(name)), after(model, form, method(name));
            CHECK(before.run(Real(1) / 2, 64) == Status::ok);
            CHECK(after.run(Real(9) / 16, 72) == Status::turn_lost);
            CHECK_THAT(after.system->reason(Status::turn_lost), Contains("axes that part"));
        }
    CHECK_NOTHROW(check_start(model));
    model.torsion_springs[0].axes_second.col(0).swap(model.torsion_springs[0].axes_second.col(2));
    CHECK_THROWS_WITH(check_start(model), Contains("torsion spring 0 (ground - wheel) has axes that part"));
}

TEST_CASE("energy is conserved through many turns", "[turns]") {
    const Turner turner = wheel("spherical", 100, 5);
    for (const std::string& form : applicable(turner.model)) {
        INFO(form);
        Trip trip(turner.model, form, method("rkmk/rk4"));
        const auto energy = [&] {
            const std::vector<BodyState> bodies = trip.bodies();
            const Real theta[] = {angle_of(trip).theta};
            for (const FirstIntegral& integral : trip.system->integrals())
                if (integral.name == "energy") return integral.value({bodies, theta});
            return Real(0);
        };
        const auto parts = [&] {
            const Real w = trip.bodies()[0].omega[2];
            return Real(w * w / 2 + trip.system->potential(0, trip.y.data()));
        };
        const Real start = energy();
        CHECK(abs(start - 5050) <= 100000 * epsilon);
        const Real h = Real(1) / 256;
        for (int i = 0; i < (KREISEL_QUAD ? 256 : 1024); ++i) {
            REQUIRE(trip.integrator->step(h * i, h, trip.y.data()) == Status::ok);
            REQUIRE(abs(energy() - start) < start / 1000000);
            REQUIRE(abs(parts() - energy()) <= 4096 * epsilon * start);
        }
    }
}

TEST_CASE("NaN in a state with springs is not accepted", "[turns]") {
    const Turner turner = wheel("revolute", 10);
    for (const Method& entry : methods())
        for (const std::string& form : formulations_of(entry, turner.model))
            for (const Real& poison : {std::numeric_limits<Real>::quiet_NaN(), std::numeric_limits<Real>::infinity()})
                for (std::size_t i = 0;; ++i) {
                    Trip trip(turner.model, form, entry);
                    if (i >= trip.y.size()) break;
                    trip.y[i] = poison;
                    const Status status = trip.run(Real(1) / 100, 1);
                    Real sum = 0;
                    for (const Real& x : trip.y) sum += x;
                    INFO(entry.description.name << " on " << form << ", entry " << i << ": " << name(status));
                    CHECK((status != Status::ok || !isfinite(sum)));
                    CHECK(status != Status::turn_lost);
                }
}
