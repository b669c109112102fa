// SPDX-License-Identifier: BSD-3-Clause
//
// Steps chosen to a tolerance: each is an attempt that meets it, units and rejected attempts leave no trace, ends are
// met, and failures are told from steps that are merely too long.
#include "methods/control/step_control.hpp"

#include <limits>

#include "mechanics/model/scales.hpp"
#include "methods/simulation.hpp"
#include "tests/mechanics/models/scaled.hpp"
#include "tests/methods/control/controlled_trip.hpp"

using namespace stepping;

namespace {

const Real tolerance = Real(1) / 10000000;

std::vector<const Method*> estimating() {
    std::vector<const Method*> found;
    for (const Method& entry : methods())
        if (entry.description.estimate > 0) found.push_back(&entry);
    return found;
}

Accuracy accuracy_for(const Model& model) { return {.tolerance = tolerance, .length = extent(model)}; }

/// Each step of a run, attempted afresh, leads to the same state with an error that meets the tolerance.
std::string steps_objection(const Method& entry, long& rejected,
                            const ControlledTrip::Bind& bind = ControlledTrip::standard) {
    const Model model = models::standard("double_pendulum");
    const Accuracy accuracy = accuracy_for(model);
    ControlledTrip trip(model, "SO3xR3", entry, accuracy, "none", bind);
    const Status status = trip.run(2);  // steps that should not have been taken may end it
    rejected += trip.stepper->rejected();
    const auto method = entry.bind(*trip.system, default_options(entry.description.options));
    const ErrorNorm norm(*trip.system, accuracy);
    std::vector<Real> y(trip.y.size()), error(static_cast<std::size_t>(trip.system->state_group().dim()));
    for (std::size_t i = 1; i < trip.times.size(); ++i) {
        const Real t = trip.times[i - 1], h = trip.times[i] - t;
        method->start(t, trip.states[i - 1].data());
        if (method->attempt(t, h, trip.states[i - 1].data(), y.data(), error.data()) != Status::ok)
            return "a step that was taken fails";
        // h is what the times differ by, which is rounded.
        if (!(norm(h, trip.states[i - 1].data(), y.data(), error.data()) < 1 + Real(1) / 1000))
            return "a step is taken whose error is " + to_text(norm(h, y.data(), y.data(), error.data()));
        Real apart = 0;
        for (std::size_t k = 0; k < y.size(); ++k) apart = max(apart, Real(abs(y[k] - trip.states[i][k])));
        if (!(apart < 100000 * epsilon)) return "a step leads elsewhere, by " + to_text(apart);
    }
    return status == Status::ok ? "" : "a run fails";
}

/// Takes every attempt that ends in no status, whatever its error; the sizes are those of a controller.
class Careless final : public Stepper {
  public:
    Careless(const Method& entry, System& system, const Accuracy& accuracy)
        : method_(entry.bind(system, default_options(entry.description.options))),
          norm_(system, accuracy),
          controller_("pi", entry.description.estimate),
          new_(static_cast<std::size_t>(system.state_group().size())),
          error_(static_cast<std::size_t>(system.state_group().dim())) {}
    Status start(const Real& t, const Real&, const Real* y) override { return method_->start(t, y); }
    Status step(Real& t, const Real& limit, Real* y) override {
        const FittedStep fitted = fit(t, h_, limit);
        const Status status = method_->attempt(t, fitted.h, y, new_.data(), error_.data());
        if (status != Status::ok) return status;
        const Real error = norm_(fitted.h, y, new_.data(), error_.data());
        ++(error <= 1 ? accepted_ : rejected_);
        h_ *= error <= 1 ? controller_.after_acceptance(h_, error) : controller_.after_rejection(error);
        std::copy(new_.begin(), new_.end(), y);
        method_->accept(false);
        t = fitted.end;
        return Status::ok;
    }
    std::string failed_part() const override { return ""; }
    const Work& work() const override { return method_->work(); }

  private:
    std::unique_ptr<Integrator> method_;
    ErrorNorm norm_;
    StepSizeController controller_;
    std::vector<Real> new_, error_;
    Real h_ = Real(1) / 4;  // too long for all methods
};

/// A weight that is never finite.
Model breaking() {
    Model model = models::standard("forced_heavy_top");
    model.gravity.amplitude = std::numeric_limits<Real>::infinity();
    return model;
}

}  // namespace

TEST_CASE("every step to a tolerance is an attempt that meets it", "[control]") {
    REQUIRE(estimating().size() >= 5);
    long rejected = 0;
    for (const Method* entry : estimating()) {
        INFO(entry->description.name);
        CHECK(steps_objection(*entry, rejected) == "");
    }
    CHECK(rejected > 10);
}

TEST_CASE("a stepper that takes rejected steps is seen", "[control]") {
    const auto careless = [](const Method& entry, System& system, Projection&, const Accuracy& accuracy) {
        return std::make_unique<Careless>(entry, system, accuracy);
    };
    for (const Method* entry : estimating()) {
        INFO(entry->description.name);
        long rejected = 0;
        CHECK_THAT(steps_objection(*entry, rejected, careless), Catch::Contains("a step is taken whose error is"));
    }
}

TEST_CASE("units that are powers of two change no bit of steps to a tolerance", "[control]") {
    const Model model = models::standard("double_pendulum");
    for (const char* name : {"rkmk/dopri5", "rkmk/bs3"})
        for (const std::string controller : {"elementary", "pi", "pid"}) {
            const auto run = [&](const Model& scaled, const Real& t_end) {
                Simulation simulation(scaled, {.method = name,
                                               .projection = "position_velocity",
                                               .tolerance = tolerance,
                                               .controller = controller});
                std::vector<Real> times;
                CHECK(simulation.advance(t_end, [&](const Simulation& now) { times.push_back(now.time()); }) ==
                      Status::ok);
                return std::pair(times, simulation.bodies());
            };
            const Real t_end = Real(1) / 2;
            const auto [times, bodies] = run(model, t_end);
            CHECK(times.size() > 5);
            for (const models::Units& units : models::other_units()) {
                INFO(name << " " << controller << " " << units.length << " " << units.mass << " " << units.time);
                const auto [scaled_times, scaled_bodies] = run(models::scaled(model, units), t_end * units.T());
                REQUIRE(scaled_times.size() == times.size());
                for (std::size_t i = 0; i < times.size(); ++i) CHECK(scaled_times[i] == times[i] * units.T());
                CHECK(scaled_bodies[1].x == bodies[1].x * units.L());
                CHECK(scaled_bodies[1].R == bodies[1].R);
            }
        }
}

TEST_CASE("place and orientation change no step but by round-off", "[control]") {
    const Model model = models::standard("forced_heavy_top");
    Model moved = model;
    for (Body& body : moved.bodies) body.start.x += Vec3(1000, -2000, 500);
    for (Joint& joint : moved.joints)
        (joint.first == ground ? joint.r_first : joint.r_second) += Vec3(1000, -2000, 500);
    const auto steps = [](const Model& of) {
        Simulation simulation(of, {.method = "rkmk/dopri5", .tolerance = tolerance});
        CHECK(simulation.advance(1) == Status::ok);
        return std::pair(simulation.stepper()->accepted(), simulation.stepper()->rejected());
    };
    CHECK(steps(moved) == steps(model));
}

TEST_CASE("a first step that leaves its chart is rejected, and the run goes on", "[control]") {
    Simulation simulation(models::standard("heavy_top"), {.method = "rkmk/dopri5", .tolerance = 50});
    CHECK(simulation.advance(Real(1) / 2) == Status::ok);
    CHECK(simulation.stepper()->rejected() > 0);
    CHECK(simulation.time() == Real(1) / 2);
}

TEST_CASE("a run that cannot go on says why", "[control]") {
    Simulation simulation(breaking(), {.method = "rkmk/dopri5", .tolerance = tolerance});
    CHECK(simulation.advance(1) == Status::non_finite);
    CHECK(simulation.time() == 0);
}

TEST_CASE("a tolerance that no step can meet ends as step_too_small", "[control]") {
    Simulation simulation(models::standard("heavy_top"),
                          {.method = "rkmk/bs3", .tolerance = std::numeric_limits<Real>::min()});
    CHECK(simulation.advance(1) == Status::step_too_small);
    CHECK_THAT(simulation.failure(), Catch::Contains("step of rkmk/bs3: step_too_small"));
}

TEST_CASE("projected steps to a tolerance stay on the constraints", "[control]") {
    const Model model = models::standard("double_pendulum");
    for (const Method* entry : estimating()) {
        INFO(entry->description.name);
        ControlledTrip trip(model, "SO3xR3", *entry, accuracy_for(model), "position_velocity");
        REQUIRE(trip.run(1) == Status::ok);
        VecX rows(trip.system->constraints());
        trip.system->position_residual(1, trip.y.data(), rows.data());
        CHECK(rows.norm() < 100 * epsilon);
    }
}

TEST_CASE("methods without an estimate are declined by name", "[control]") {
    CHECK_THROWS_WITH(Simulation(models::standard("heavy_top"), {.method = "rkmk/rk4", .tolerance = tolerance}),
                      Catch::Contains("rkmk/rk4 has no estimate"));
    CHECK_THROWS_WITH(StepSizeController("p", 5), Catch::Contains("elementary, pi, pid"));
}
