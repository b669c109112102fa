// SPDX-License-Identifier: BSD-3-Clause
//
// Implicit methods on R, where they are the classical ones, and how steps fail. Their equations on groups are
// checked in tests/judges/steps/step_checks.hpp.
#include <array>
#include <cmath>

#include "engine/run.hpp"
#include "engine/skip.hpp"
#include "mechanics/space_axes.hpp"
#include "tests/methods/poisoned.hpp"
#include "tests/methods/stepping.hpp"

using namespace kreisel;
using namespace models;
using namespace stepping;

namespace {

template <class F>
void for_each_on_constraints(F f) {
    for (const Method& entry : methods())
        if (entry.description.meets_constraints()) {
            INFO(entry.description.name);
            f(entry);
        }
}

/// x'' = f(t, x, x') with unit mass on R, in both forms of the interface.
class LineSystem final : public System {
  public:
    using Force = Real (*)(const Real& t, const Real& x, const Real& v);
    explicit LineSystem(Force force) : System(std::make_shared<AdditiveGroup>(1)), force_(force) {}
    Status accelerations(const Real& t, const Real* q, const Real* v, Real* dv, Real*) override {
        *dv = force_(t, *q, *v);
        return isfinite(*dv) ? Status::ok : Status::non_finite;
    }
    void applied_force(const Real& t, const Real* q, const Real* v, Real* f) const override { *f = force_(t, *q, *v); }
    bool is_dissipative() const override { return true; }
    Real force_at(const Real& t, const std::array<Real, 2>& y) const { return force_(t, y[0], y[1]); }

  private:
    Force force_;
};

Real oscillator(const Real& t, const Real& x, const Real& v) { return sin(2 * t) - 4 * sin(x) - v / 4; }
/// So fast that the equations of a long step have no real solution.
Real runaway(const Real&, const Real&, const Real& v) { return 1000 * (1 + v * v); }

bool declines(const Method& entry, const System& system) {
    return entry.factory.declines && !entry.factory.declines(system).empty();
}

Model resized(Model model, const Real& length, const Real& mass) {
    for (Body& body : model.bodies) {
        body.mass *= mass;
        body.J *= mass * length * length;
        body.start.x *= length, body.start.v *= length;
    }
    for (Joint& joint : model.joints) joint.r_first *= length, joint.r_second *= length;
    model.gravity.g *= length;
    return model;
}

/// States (x, v) after 0, 1, ... steps.
std::vector<std::array<Real, 2>> march(const Method& entry, const OptionValues& options, LineSystem& system,
                                       const Real& h, int steps) {
    std::vector<std::array<Real, 2>> states = {{Real(1), Real(1) / 2}};
    const auto integrator = entry.bind(system, options);
    REQUIRE(integrator->start(0, states[0].data()) == Status::ok);
    for (int i = 0; i < steps; ++i) {
        states.push_back(states.back());
        REQUIRE(integrator->step(h * i, h, states.back().data()) == Status::ok);
    }
    return states;
}

}  // namespace

TEST_CASE("on R the generalised-alpha method is the classical one", "[methods]") {
    const Method& entry = method("generalized_alpha/index2");
    for (const double option : {0.0, 0.5, 0.9}) {
        LineSystem system(oscillator);
        const Real rho = decimal(option), h = Real(1) / 16;
        const auto y = march(entry, {{"rho", option}}, system, h, 8);
        const Real am = (2 * rho - 1) / (rho + 1), af = rho / (rho + 1);
        const Real gamma = Real(1) / 2 + af - am, beta = (gamma + Real(1) / 2) * (gamma + Real(1) / 2) / 4;
        Real last = 0;
        for (std::size_t i = 0; i + 1 < y.size(); ++i) {
            // a and a+ of this step from its two updates, which are linear in them.
            const Real dv = (y[i + 1][1] - y[i][1]) / h, dx = (y[i + 1][0] - y[i][0] - h * y[i][1]) / (h * h);
            const Real determinant = (1 - gamma) * beta - gamma * (Real(1) / 2 - beta);
            const Real a = (beta * dv - gamma * dx) / determinant;
            const Real a_next = ((1 - gamma) * dx - (Real(1) / 2 - beta) * dv) / determinant;
            const Real f = system.force_at(h * static_cast<int>(i), y[i]),
                       f_next = system.force_at(h * static_cast<int>(i + 1), y[i + 1]);
            const Real slack = 10000 * epsilon / abs(determinant);
            CHECK(abs((1 - am) * a_next + am * a - (1 - af) * f_next - af * f) <= slack);
            if (i > 0) CHECK(abs(a - last) <= slack);
            last = a_next;
        }
    }
}

TEST_CASE("on R the generalised-alpha method starts with v' at its own time", "[methods]") {
    // a(0) = v'(Delta h) + O(h^2), Delta = alpha_m - alpha_f; for rho = 0, Delta = -1.
    double errors[2];
    for (int i = 0; i < 2; ++i) {
        LineSystem system([](const Real& t, const Real&, const Real&) -> Real { return sin(2 * t); });
        const Real h = Real(1) / (16 << i);
        const auto y = march(method("generalized_alpha/index2"), {{"rho", 0.0}}, system, h, 1);
        const Real gamma = Real(3) / 2, beta = 1;  // rho = 0
        const Real dv = (y[1][1] - y[0][1]) / h, dx = (y[1][0] - y[0][0] - h * y[0][1]) / (h * h);
        const Real a = (beta * dv - gamma * dx) / ((1 - gamma) * beta - gamma * (Real(1) / 2 - beta));
        errors[i] = std::abs(to_double(a - sin(-2 * h)));
    }
    CHECK(std::log2(errors[0] / errors[1]) >= 1.9);
}

TEST_CASE("on R the BLieDF method is the backward differentiation formula", "[methods]") {
    LineSystem system(oscillator);
    const Real h = Real(1) / 16;
    const auto y = march(method("multistep/bliedf2"), {}, system, h, 8);
    for (std::size_t i = 2; i < y.size(); ++i) {
        const auto difference = [&](std::size_t k) { return (3 * y[i][k] - 4 * y[i - 1][k] + y[i - 2][k]) / (2 * h); };
        CHECK(abs(difference(0) - y[i][1]) <= 1000 * epsilon);
        CHECK(abs(difference(1) - system.force_at(h * static_cast<int>(i), y[i])) <= 1000 * epsilon);
    }
}

TEST_CASE("the first step is as accurate as any other", "[methods]") {
    // Its error against a method of order 9, which is far smaller, falls with h^(p+1): an own start must not cost an
    // order.
    const Method& precise = method("rkmk/verner9");
    for (const Method& entry : methods()) {
        if (!entry.description.is_implicit() || declines(entry, LineSystem(oscillator))) continue;
        INFO(entry.description.name);
        double errors[2];
        for (int i = 0; i < 2; ++i) {
            LineSystem system(oscillator);
            const Real h = Real(1) / ((entry.description.order.configuration > 4 ? 8 : 64) << i);
            const auto y = march(entry, default_options(entry.description.options), system, h, 1).back();
            const auto exact = march(precise, default_options(precise.description.options), system, h, 1).back();
            errors[i] = std::hypot(to_double(y[0] - exact[0]), to_double(y[1] - exact[1]));
        }
        CHECK(std::log2(errors[0] / errors[1]) >= entry.description.order.configuration + 1 - 0.2);
    }
}

TEST_CASE("methods stay on the constraints that they meet, and report multipliers of their own from the first step on",
          "[methods]") {
    for_each_on_constraints([](const Method& entry) {
        for (const Named& named : for_methods())
            for (const std::string& formulation : applicable(named.model)) {
                if (!runs_on(entry, named.model, formulation)) continue;
                INFO(named.name << " as " << formulation);
                Trip trip(named.model, formulation, entry);
                System& s = *trip.system;
                CHECK(trip.integrator->multipliers() == nullptr);
                const Real speed = spins_fast(named.model) ? 150 : 10;
                for (int i = 0; i < 20; ++i) {
                    REQUIRE(trip.integrator->step(Real(i) / 1000, Real(1) / 1000, trip.y.data()) == Status::ok);
                    const Real t = Real(i + 1) / 1000;
                    // RATTLie's rows stand beside momenta, at whose round-off its iteration ends.
                    const bool momenta = entry.description.claims(Property::symplectic);
                    CHECK(to_double(trip.position_defect(t) / epsilon) <= (momenta ? 3000 : 1000));
                    CHECK(to_double(trip.velocity_defect(t) / (epsilon * speed)) <= 1000);
                }
                VecX dv(s.velocities()), exact(s.constraints());
                if (exact.size() == 0 || !entry.description.reports_multipliers) continue;
                REQUIRE(trip.integrator->multipliers() != nullptr);
                const Real* v = s.v(trip.y.data());
                REQUIRE(s.accelerations(Real(20) / 1000, trip.y.data(), v, dv.data(), exact.data()) == Status::ok);
                const Eigen::Map<const VecX> own(trip.integrator->multipliers(), exact.size());
                const bool coarse = spins_fast(named.model) || entry.description.order.multipliers == 1;
                CHECK((own - exact).norm() <= max(Real(1), Real(exact.norm())) / (coarse ? 10 : 1000));
            }
    });
}

TEST_CASE("multipliers of implicit Euler steps on positions are of order 1 from the second step on", "[methods]") {
    // The first one goes from velocities on C v + b = 0 to chords, which are off it by h/2 xi: half of xi is missing in
    // C v', and lambda is wrong by S^{-1} xi/2.
    struct Errors {
        double plain, without_the_chord;
    };
    const auto errors_after = [](int steps, const Real& h) {
        Trip trip(standard("forced_heavy_top"), "SO3xR3", method("multistep/bliedf1_index3"));
        REQUIRE(trip.run(steps * h, steps) == Status::ok);
        System& s = *trip.system;
        const Real t = steps * h, *y = trip.y.data(), *v = s.v(y);
        VecX dv(6), exact(3), xi(3), of_chord(3);
        REQUIRE(s.accelerations(t, y, v, dv.data(), exact.data()) == Status::ok);
        s.acceleration_bias(t, y, v, xi.data());
        xi /= -2;
        const VecX zero = VecX::Zero(6);
        REQUIRE(s.solve_kkt(t, y, zero.data(), xi.data(), dv.data(), of_chord.data()) == Status::ok);
        const VecX error = Eigen::Map<const VecX>(trip.integrator->multipliers(), 3) - exact;
        return Errors{to_double(error.norm() / exact.norm()), to_double((error - of_chord).norm() / exact.norm())};
    };
    const Real h = Real(1) / 8192;
    const Errors first = errors_after(1, h), first_of_long = errors_after(1, 2 * h);
    CHECK(std::log2(first_of_long.plain / first.plain) == Approx(0).margin(0.1));
    CHECK(std::log2(first_of_long.without_the_chord / first.without_the_chord) == Approx(1).margin(0.1));
    CHECK(first.without_the_chord < first.plain / 10);
    for (const int steps : {2, 8})
        CHECK(std::log2(errors_after(steps, 2 * h).plain / errors_after(steps, h).plain) == Approx(1).margin(0.1));
}

TEST_CASE("short steps on positions alone add up no round-off of places over h", "[methods]") {
    if (KREISEL_QUAD) return;  // it shows where eps/h^2 is larger than h^2
    const Real t_end = Real(1) / 16;
    Trip exact(standard("forced_heavy_top"), "SO3xR3", method("rkmk/rk4"), "position_velocity");
    REQUIRE(exact.run(t_end, 512) == Status::ok);
    for (const Method& entry : methods()) {
        if (entry.description.order.configuration == 1) continue;  // its own error is larger
        if (!entry.description.reports_multipliers || entry.description.meets_velocities) continue;
        INFO(entry.description.name);
        Trip trip(standard("forced_heavy_top"), "SO3xR3", entry);
        REQUIRE(trip.run(t_end, 16384) == Status::ok);
        CHECK(worst(distance(trip.bodies(), exact.bodies())) < 1e-8);
    }
}

TEST_CASE("steps onto positions end however short they are", "[methods]") {
    // What changes velocities is known to the round-off of places over h, 8 million times that of the velocities.
    const Real h = Real(1) / 8388608;
    constexpr long steps = 256;
    for (const char* problem : {"double_pendulum", "forced_heavy_top"}) {
        Trip exact(standard(problem), "SO3xR3", method("rkmk/rk4"));
        REQUIRE(exact.run(h * Real(steps), 16) == Status::ok);
        for (const Method& entry : methods()) {
            if (!entry.description.meets_positions || !runs_on(entry, standard(problem), "SO3xR3")) continue;
            INFO(entry.description.name << " on " << problem);
            Trip trip(standard(problem), "SO3xR3", entry);
            REQUIRE(trip.run(h * Real(steps), steps) == Status::ok);
            // Velocities that follow from positions alone have the round-off of places over h themselves.
            const Real bound = Real(1) / (entry.description.meets_velocities ? 100000000 : 1000000);
            CHECK(worst(distance(trip.bodies(), exact.bodies())) < bound);
        }
    }
}

TEST_CASE("methods meet the constraints of small and of large systems alike", "[methods]") {
    // Lengths in units of L metres, masses in units of m kilograms; gravity follows, so that the motion is the same.
    for_each_on_constraints([](const Method& entry) {
        for (const double length : {1.0 / 1048576, 32.0})
            for (const double mass : {1.0 / 1048576, 1048576.0}) {
                INFO("L = " << length << ", m = " << mass);
                Trip trip(resized(standard("double_pendulum"), Real(length), Real(mass)), "SO3xR3", entry);
                REQUIRE(trip.run(Real(1) / 10, 20) == Status::ok);
                CHECK(trip.position_defect() <= 1000 * epsilon * length);
                CHECK(trip.velocity_defect() <= 10000 * epsilon * length);
            }
    });
}

TEST_CASE("a run reports the multipliers of the method, where it has any", "[methods]") {
    for_each_on_constraints([](const Method& entry) {
        Cell cell{.problem = "forced_heavy_top",
                  .parameters = defaults(problem("forced_heavy_top")),
                  .formulation = "SO3xR3",
                  .method = entry.description.name,
                  .options = default_options(entry.description.options),
                  .projection = "none",
                  .projection_options = {},
                  .t_end = 1,
                  .steps = 64,
                  .samples = 0,
                  .metrics = {}};
        CHECK(why_skipped(cell).empty());
        const Outcome outcome = run_cell(cell, nullptr, {});
        REQUIRE(outcome.status == "ok");
        Trip trip(standard("forced_heavy_top"), "SO3xR3", entry);
        REQUIRE(trip.run(1, 64) == Status::ok);
        VecX dv(6), from_state(3);
        const Real* v = trip.system->v(trip.y.data());
        REQUIRE(trip.system->accelerations(1, trip.y.data(), v, dv.data(), from_state.data()) == Status::ok);
        for (std::size_t i = 0; i < 3 && entry.description.reports_multipliers; ++i) {
            CHECK(from_number(outcome.final->multipliers.at(i)) == trip.integrator->multipliers()[i]);
            CHECK(from_number(outcome.final->multipliers.at(i)) != from_state[static_cast<Eigen::Index>(i)]);
        }
        cell.projection = "position";
        CHECK(why_skipped(cell).find("nothing is left to project") != std::string::npos);
    });
}

TEST_CASE("velocities turn into space axes and back", "[methods]") {
    for (const Named& named : for_methods())
        for (const std::string& formulation : applicable(named.model)) {
            INFO(named.name << " as " << formulation);
            const auto system = make_system(named.model, formulation);
            const auto* axes = dynamic_cast<const SpaceAxes*>(system.get());
            REQUIRE(axes != nullptr);
            const std::vector<Real> y = initial_state(*system, named.model);
            std::vector<BodyState> bodies(named.model.bodies.size());
            system->read(y.data(), bodies.data());
            const Real* v = system->v(y.data());
            VecX turned(system->velocities()), back(turned);
            axes->to_space_axes(y.data(), v, turned.data());
            axes->from_space_axes(y.data(), turned.data(), back.data());
            CHECK((back - Eigen::Map<const VecX>(v, back.size())).norm() <= 16 * epsilon * (1 + back.norm()));
            const auto parts = turned.size() / 3, each = parts / static_cast<Eigen::Index>(bodies.size());
            for (Eigen::Index i = 0; i < parts; ++i) {
                const BodyState& body = bodies[static_cast<std::size_t>(i / each)];
                const Vec3 angular = body.R * body.omega, expected = i % each == each - 1 ? angular : body.v;
                CHECK((turned.segment<3>(3 * i) - expected).norm() <= 16 * epsilon * (1 + expected.norm()));
            }
        }
}

TEST_CASE("implicit steps of a fast top take few evaluations, in every formulation", "[methods]") {
    if (KREISEL_QUAD) return;  // twice the digits take more
    const Model top = standard("heavy_top");
    const Real h = Real(1) / 1000;
    for (const auto& [method_name, most] :
         {std::pair("rkmk/implicit_midpoint", 3), std::pair("generalized_alpha/index2", 4),
          std::pair("multistep/bliedf2", 5)})
        for (const std::string& formulation : applicable(top)) {
            if (!runs_on(method(method_name), top, formulation)) continue;
            INFO(method_name << " as " << formulation);
            Trip trip(top, formulation, method(method_name));
            REQUIRE(trip.run(h * 100, 100) == Status::ok);
            const long before = trip.system->evaluations();
            const int steps = 500;
            for (int i = 100; i < 100 + steps; ++i)
                REQUIRE(trip.integrator->step(h * i, h, trip.y.data()) == Status::ok);
            CHECK(trip.system->evaluations() - before <= most * steps);
        }
}

TEST_CASE("a step without a solution is newton_failed, and leaves the state", "[methods]") {
    for (const Method& entry : methods()) {
        if (!entry.description.is_implicit()) continue;
        INFO(entry.description.name);
        LineSystem system(runaway);
        if (declines(entry, system)) continue;
        const auto integrator = entry.bind(system, default_options(entry.description.options));
        Real y[2] = {1, 0};
        CHECK(integrator->step(0, 1, y) == Status::newton_failed);
        CHECK(y[0] == 1);
        CHECK(y[1] == 0);
    }
}

TEST_CASE("NaN never ends as ok in an implicit step", "[methods]") {
    using enum PoisonedSystem::What;
    for (const Method& entry : methods()) {
        if (!entry.description.is_implicit() || !runs_on(entry, standard("double_pendulum"), "SO3xR3")) continue;
        for (const auto what : {acceleration, mass, applied, gyroscopic, position, velocity, jacobian})
            for (const Real& poison : {not_a_number, infinite})
                for (const int healthy_steps : {0, 3, 9}) {
                    // A method without multipliers uses only the index-1 form.
                    const bool multipliers = entry.description.reports_multipliers;
                    if (!multipliers && what != acceleration) continue;
                    if (multipliers && what == acceleration && healthy_steps > 0) continue;
                    // Rows on velocities alone do not enter, nor do their own.
                    if (multipliers && !entry.description.meets_velocities && what == velocity) continue;
                    // Variational methods take the gyroscopic force from the transport of momenta, and solve for none
                    // of the accelerations.
                    const bool variational = entry.description.claims(Property::symplectic);
                    if (variational && (what == gyroscopic || what == acceleration)) continue;
                    INFO(entry.description.name << ", quantity " << static_cast<int>(what) << ", step "
                                                << healthy_steps);
                    Trip trip(standard("double_pendulum"), "SO3xR3", entry);
                    PoisonedSystem system(*trip.system);
                    const auto integrator = entry.bind(system, default_options(entry.description.options));
                    const Real h = Real(1) / 100;
                    for (int i = 0; i < healthy_steps; ++i)
                        REQUIRE(integrator->step(h * i, h, trip.y.data()) == Status::ok);
                    const auto before = trip.y;
                    system.what = what, system.poison = poison;
                    CHECK(integrator->step(h * healthy_steps, h, trip.y.data()) == Status::non_finite);
                    CHECK(trip.y == before);
                    system.what = nothing;
                    CHECK(integrator->step(h * healthy_steps, h, trip.y.data()) == Status::ok);
                }
    }
}

TEST_CASE("NaN in the state never ends as ok in a step that meets constraints", "[methods]") {
    for_each_on_constraints([](const Method& entry) {
        const Real h = Real(1) / 100;
        for (const int healthy_steps : {0, 3}) {
            Trip start(standard("double_pendulum"), "SO3xR3", entry);
            for (std::size_t i = 0; i < start.y.size(); ++i) {
                Trip trip(standard("double_pendulum"), "SO3xR3", entry);
                for (int k = 0; k < healthy_steps; ++k)
                    REQUIRE(trip.integrator->step(h * k, h, trip.y.data()) == Status::ok);
                trip.y[i] = not_a_number;
                INFO("entry " << i << ", step " << healthy_steps);
                CHECK(trip.integrator->step(h * healthy_steps, h, trip.y.data()) != Status::ok);
            }
        }
    });
}
