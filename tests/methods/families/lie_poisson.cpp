// SPDX-License-Identifier: BSD-3-Clause
//
// The Lie-Poisson form of a body that turns about a fixed point, SO3-LiePoisson: without forces, methods keep its
// momentum in space, and with it |m|, whatever the step; with forces it has the solution of SO3. Controls have actions
// with one mistake.
#include "mechanics/actions/coadjoint_action.hpp"
#include "mechanics/forwarding_system.hpp"
#include "mechanics/free_body/free_rotation.hpp"
#include "mechanics/model/pivots.hpp"
#include "tests/methods/stepping.hpp"

namespace lie_poisson_form {

using namespace kreisel;
using namespace models;
using namespace stepping;

namespace {

constexpr const char* lie_poisson = "SO3-LiePoisson";

/// With a full inertia, about no axis of symmetry.
Model free_body() {
    Model model = standard("free_top");
    model.bodies[0].J << 3, 1, -1, 1, 5, 1, -1, 1, 4;
    model.bodies[0].start.omega = Vec3(2, -1, 3) / 2;
    return model;
}

const long steps = KREISEL_QUAD ? 100 : 1000;
const Real h = Real(1) / 16;

struct Change {
    Real casimir, momentum;  ///< of |m| and of R m, over |m|
};

Change change_over(const System& system, const Model& model, Integrator& integrator) {
    const Mat3& J = model.bodies[0].J;
    std::vector<Real> y = initial_state(system, model);
    const auto momentum = [&]() -> Vec3 { return J * vec3(system.v(y.data())); };
    const auto in_space = [&]() -> Vec3 { return mat3(y.data()) * momentum(); };
    const Real size = momentum().norm();
    const Vec3 before = in_space();
    Change most{0, 0};
    REQUIRE(integrator.start(0, y.data()) == Status::ok);
    for (long i = 0; i < steps; ++i) {
        REQUIRE(integrator.step(h * Real(i), h, y.data()) == Status::ok);
        most.casimir = max(most.casimir, Real(abs(momentum().norm() - size) / size));
        most.momentum = max(most.momentum, Real((in_space() - before).norm() / size));
    }
    return most;
}

Change change_over(const Method& entry, const OptionValues& options, const std::string& formulation) {
    const Model model = free_body();
    Trip trip(model, formulation, entry, options);
    return change_over(*trip.system, model, *trip.integrator);
}

/// Slopes keep the part of v' that turns omega.
struct TurnedTwice : CoadjointAction {
    using CoadjointAction::CoadjointAction;
    void from_tangent(const Real*, Real*) const override {}
};

/// m turns with R in place of against it.
struct TurnedBackwards : CoadjointAction {
    explicit TurnedBackwards(const Pivoted& body) : CoadjointAction(body.J_O, body.J_O_inverse), J(body.J_O) {}
    void append_exp(const Real* y, const Real* u, Real* out) const override {
        const Vec3 m = J * vec3(y + 9);
        CoadjointAction::append_exp(y, u, out);
        store(Vec3(J.inverse() * (SO3::exp(vec3(u)) * m)), out + 9);
    }
    Mat3 J;
};

/// m stays where it is, and only a torque changes it.
struct NotTurned : TurnedBackwards {
    using TurnedBackwards::TurnedBackwards;
    void append_exp(const Real* y, const Real* u, Real* out) const override {
        const Vec3 omega = vec3(y + 9);
        CoadjointAction::append_exp(y, u, out);
        store(omega, out + 9);
    }
};

/// omega goes to m and back with all digits of m.
struct ThereAndBack : CoadjointAction {
    using CoadjointAction::CoadjointAction;
    void append_exp(const Real* y, const Real* u, Real* out) const override {
        std::vector<Real> turn(static_cast<std::size_t>(size()));
        identity(turn.data());
        CoadjointAction::append_exp(turn.data(), u, turn.data());
        multiply(y, turn.data(), out);
    }
};

class Acted final : public ForwardingSystem {
  public:
    Acted(const Model& model, const StateAction* action) : ForwardingSystem(make_system(model, "SO3")), acts_(action) {}
    const StateAction* action() const override { return acts_; }

  private:
    const StateAction* acts_;
};

/// A method on a body, with the action of the body's own where there is one.
struct Bound {
    std::unique_ptr<StateAction> action;
    std::unique_ptr<System> system;
    std::unique_ptr<Integrator> integrator;
};

/// Of |m| after 20,000 steps by `step` of bodies whose inertias have no exact inverse, over |m|.
template <class Bind>
Real change_by_round_off(const Real& step, Bind bind) {
    constexpr long many = 20000;
    Real most = 0;
    for (const Vec3& moments : {Vec3(2, 1, Real(2) / 3), Vec3(3, 1, 2)}) {
        Model model = free_body();
        model.bodies[0].J = moments.asDiagonal();
        const Bound bound = bind(model);
        std::vector<Real> y = initial_state(*bound.system, model);
        const auto size = [&] { return Real((model.bodies[0].J * vec3(bound.system->v(y.data()))).norm()); };
        const Real before = size();
        REQUIRE(bound.integrator->start(0, y.data()) == Status::ok);
        for (long i = 0; i < many; ++i) REQUIRE(bound.integrator->step(step * Real(i), step, y.data()) == Status::ok);
        most = max(most, Real(abs(size() / before - 1)));
    }
    return most;
}

/// |omega - exact| of the free body after a quarter second in N steps.
Real error_of(const Method& entry, const StateAction& action, long N) {
    const Model model = free_body();
    const Body& body = model.bodies[0];
    Acted system(model, &action);
    const auto integrator = entry.bind(system, default_options(entry.description.options));
    std::vector<Real> y = initial_state(system, model);
    const Real t_end = Real(1) / 4, step = t_end / Real(N);
    for (long i = 0; i < N; ++i) REQUIRE(integrator->step(step * Real(i), step, y.data()) == Status::ok);
    return (vec3(system.v(y.data())) - free_rotation(body.J, body.start.R, body.start.omega, t_end).omega).norm();
}

/// Every choice of each option that has choices, the others as declared.
std::vector<OptionValues> choices(const Method& entry) {
    std::vector<OptionValues> all = {default_options(entry.description.options)};
    for (const OptionDescription& option : entry.description.options)
        for (const std::string& choice : option.choices) {
            OptionValues options = all.front();
            options[option.name] = choice;
            if (entry.factory.why_not(options).empty()) all.push_back(options);
        }
    return all;
}

}  // namespace

TEST_CASE("methods keep the Casimir and the momentum of a free body in Lie-Poisson form", "[methods][lie_poisson]") {
    int seen = 0;
    for (const Method& entry : methods()) {
        if (!runs_on(entry, free_body(), lie_poisson)) continue;
        for (const OptionValues& options : choices(entry)) {
            INFO(entry.description.name);
            ++seen;
            const Change change = change_over(entry, options, lie_poisson);
            CHECK(change.casimir <= 10000 * epsilon);
            CHECK(change.momentum <= 10000 * epsilon);
        }
    }
    CHECK(seen >= 74);
}

TEST_CASE("round-off does not lead a momentum off its orbit", "[methods][lie_poisson]") {
    if (KREISEL_QUAD) return;  // slow, and the same code
    const auto check = [](const char* name, const OptionValues& changed) {
        const Method& entry = method(name);
        const OptionValues options = with_defaults(changed, entry.description.options);
        for (const Real& step : {Real(1) / 1024, Real(1) / 128}) {
            const Real change = change_by_round_off(step, [&](const Model& model) {
                Bound bound{nullptr, make_system(model, lie_poisson), nullptr};
                bound.integrator = entry.bind(*bound.system, options);
                return bound;
            });
            INFO(name << ", h = " << to_text(step) << ": " << to_text(Real(change / epsilon)) << " eps");
            CHECK(change < 300 * epsilon);
        }
    };
    for (const char* coordinates : {"exp", "cayley"}) check("rkmk/rk4", {{"coordinates", std::string(coordinates)}});
    for (const char* name : {"crouch_grossman/cg3a", "rkmk/gauss2", "multistep/adams_bashforth3"}) check(name, {});
}

TEST_CASE("a momentum that is rounded as a velocity leaves its orbit", "[methods][lie_poisson][control]") {
    if (KREISEL_QUAD) return;  // slow, and the same code
    const Real change = change_by_round_off(Real(1) / 1024, [](const Model& model) {
        const Pivoted body = pivoted_bodies(model)[0];
        Bound bound{std::make_unique<ThereAndBack>(body.J_O, body.J_O_inverse), nullptr, nullptr};
        bound.system = std::make_unique<Acted>(model, bound.action.get());
        const Method& rk4 = method("rkmk/rk4");
        bound.integrator = rk4.bind(*bound.system, default_options(rk4.description.options));
        return bound;
    });
    CHECK(change > 600 * epsilon);
}

TEST_CASE("where velocities are additive, methods keep neither", "[methods][lie_poisson][control]") {
    for (const char* name : {"rkmk/rk4", "crouch_grossman/cg3a", "commutator_free/cf4", "rkmk/radau2a2",
                             "multistep/adams_bashforth3", "multistep/adams_moulton2"}) {
        const Change change = change_over(method(name), default_options(method(name).description.options), "SO3");
        INFO(name << " " << to_text(change.casimir) << " " << to_text(change.momentum));
        CHECK(change.casimir > Real(1) / 100000000);
        CHECK(change.momentum > Real(1) / 100000000);
    }
}

TEST_CASE("where velocities are additive, Gauss methods keep the Casimir alone, a quadratic integral of them",
          "[methods][lie_poisson][control]") {
    for (const char* name : {"rkmk/implicit_midpoint", "rkmk/gauss2"}) {
        INFO(name);
        const Change change = change_over(method(name), {}, "SO3");
        CHECK(change.casimir <= 10000 * epsilon);
        CHECK(change.momentum > Real(1) / 100000000);
    }
}

TEST_CASE("actions with one mistake miss the motion or the momentum", "[methods][lie_poisson][control]") {
    const Model model = free_body();
    const Pivoted body = pivoted_bodies(model)[0];
    const CoadjointAction sound(body.J_O, body.J_O_inverse);
    const TurnedTwice twice(body.J_O, body.J_O_inverse);
    const TurnedBackwards backwards(body);
    const NotTurned still(body);
    for (const char* name : {"rkmk/heun", "crouch_grossman/cg2", "commutator_free/cf2", "rkmk/implicit_midpoint",
                             "rkmk/lobatto3ab2", "multistep/adams_bashforth2"}) {
        INFO(name);
        const Method& entry = method(name);
        CHECK(error_of(entry, sound, 64) < error_of(entry, sound, 32) / 3);
        for (const StateAction* wrong :
             {static_cast<const StateAction*>(&twice), static_cast<const StateAction*>(&backwards),
              static_cast<const StateAction*>(&still)})
            CHECK(error_of(entry, *wrong, 64) > error_of(entry, *wrong, 32) * 9 / 10);
        Acted system(model, &twice);
        const auto integrator = entry.bind(system, default_options(entry.description.options));
        CHECK(change_over(system, model, *integrator).momentum > Real(1) / 1000);
    }
}

TEST_CASE("methods that move velocities in another way decline the Lie-Poisson form", "[methods][lie_poisson]") {
    const auto system = make_system(free_body(), lie_poisson);
    for (const char* name : {"generalized_alpha/index2", "multistep/bliedf2", "variational/rattlie",
                             "symmetric_projection/midpoint", "half_explicit/herk3", "splitting/strang",
                             "energy/simo_wong", "extrapolation/midpoint4", "cautionary/rk4_right_series"}) {
        INFO(name);
        CHECK(method(name).factory.declines(*system) == "momenta that move on coadjoint orbits");
    }
    for (const Method& entry : methods())
        if (entry.factory.takes_actions) CHECK(runs_on(entry, free_body(), lie_poisson));
}

TEST_CASE("the Lie-Poisson form takes one body about a fixed point", "[methods][lie_poisson]") {
    const auto why_not = [](const char* problem) { return formulation(lie_poisson).why_not(standard(problem)); };
    CHECK(why_not("free_top").empty());
    CHECK(why_not("heavy_top").empty());
    CHECK(why_not("double_pendulum") == "SO3-LiePoisson takes one body");
    CHECK_THAT(why_not("forced_free_body"), Catch::Contains("has no fixed point"));
}

}  // namespace lie_poisson_form
