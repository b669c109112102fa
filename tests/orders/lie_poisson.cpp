// SPDX-License-Identifier: BSD-3-Clause
//
// One step as SO3-LiePoisson against its declared scheme on the matrices of T*SO(3); methods without a scheme are held
// to their equations there by the checks of their steps (tests/judges/steps/dense_states.hpp). The slopes of the running step,
// (omega, torque) where it asks for them, are given to the scheme as those of a step on that group.
#include <catch2/catch.hpp>

#include "mechanics/forwarding_system.hpp"
#include "mechanics/model/pivots.hpp"
#include "methods/contract/integrator.hpp"
#include "tests/judges/families/scheme_family.hpp"
#include "tests/judges/steps/scheme_checks.hpp"
#include "tests/judges/steps/scripted_step.hpp"
#include "tests/methods/stepping.hpp"

namespace lie_poisson_steps {

using namespace kreisel;

namespace {

/// Writes down where it is asked, and the slopes there.
class Recording final : public ForwardingSystem {
  public:
    Recording(const Model& model, const std::string& formulation)
        : ForwardingSystem(make_system(model, formulation)), J_O_(pivoted_bodies(model)[0].J_O) {}

    Status accelerations(const Real& t, const Real* q, const Real* v, Real* dv, Real* lambda) override {
        VecX slope(6);
        slope.head(3) = vec3(v);
        applied_force(t, q, v, slope.data() + 3);
        slopes.push_back(slope), points.push_back(point(t, q, v));
        return ForwardingSystem::accelerations(t, q, v, dv, lambda);
    }
    DensePoint point(const Real& t, const Real* q, const Real* v) const {
        VecX element(12);
        element << Eigen::Map<const VecX>(q, 9), J_O_ * vec3(v);
        return {t, matrix_cotangent_so3().matrix(element.data()), VecX::Zero(6)};
    }
    std::vector<VecX> slopes;
    std::vector<DensePoint> points;

  private:
    Mat3 J_O_;
};

/// The script by which the stages of a scheme have these slopes as velocities; empty where a stage does not use the
/// slope before it, which decides it.
std::vector<VecX> script_of(const ClassicalScheme& scheme, const Real& h, const std::vector<VecX>& slopes) {
    std::vector<VecX> script;
    for (std::size_t i = 1; i < slopes.size(); ++i) {
        const std::vector<Real>& row = scheme.a[i];
        if (row.size() < i || row[i - 1] == 0) return {};
        VecX rest = (slopes[i] - slopes[0]) / h;
        for (std::size_t j = 0; j + 1 < i; ++j) rest -= row[j] * script[j];
        script.push_back(rest / row[i - 1]);
    }
    script.resize(scheme.a.size(), VecX::Zero(6));
    return script;
}

/// Largest difference of the points of a step from those of its scheme; nothing where its stages cannot be scripted.
std::optional<Real> deviation(const Method& method, const OptionValues& options, const std::string& formulation) {
    const Model model = models::standard("forced_heavy_top");
    Recording system(model, formulation);
    const auto integrator = method.bind(system, options);
    std::vector<Real> y = initial_state(system, model);
    const Real t = Real(1) / 8, h = Real(1) / 8;
    const DensePoint start = system.point(t, system.q(y.data()), system.v(y.data()));
    REQUIRE(integrator->start(t, y.data()) == Status::ok);
    REQUIRE(integrator->step(t, h, y.data()) == Status::ok);

    const SchemeFamily& family = *family_of(*method.factory.scheme);
    const std::vector<VecX> script = script_of(family.classical(*method.factory.scheme), h, system.slopes);
    if (script.empty()) return std::nullopt;
    ScriptedStep given{matrix_cotangent_so3(), h, start, script, options, method.description.order.configuration};
    given.start.v = system.slopes[0];
    const DenseStep expected = family.step(*method.factory.scheme, given);
    const auto apart = [](const DensePoint& a, const DensePoint& b) {
        return max(Real(abs(Real(a.t - b.t))), Real((a.q - b.q).cwiseAbs().maxCoeff()));
    };
    Real most = apart(expected.result, system.point(t + h, system.q(y.data()), system.v(y.data())));
    for (std::size_t i = 0; i < system.points.size(); ++i)
        most = max(most, apart(expected.stages[i], system.points[i]));
    return most;
}

/// A system that hides the group that acts on its states, and a method on it.
class Hidden final : public Integrator {
  public:
    Hidden(System& system, const Method& method, const OptionValues& options)
        : system_(system), integrator_(method.factory.make(system_, options, method.description)) {}
    Status start(const Real& t, const Real* y) override { return integrator_->start(t, y); }
    Status step(const Real& t, const Real& h, Real* y) override { return integrator_->step(t, h, y); }

  private:
    struct Forwarding final : ForwardingSystem {
        using ForwardingSystem::ForwardingSystem;
        const StateAction* action() const override { return nullptr; }
    };
    Forwarding system_;
    std::unique_ptr<Integrator> integrator_;
};

/// Adds to velocities whatever acts on states.
Method additive(const Method& method) {
    Method wrong = method;
    wrong.factory.make = [&method](System& system, const OptionValues& options, const MethodDescription&) {
        return std::make_unique<Hidden>(system, method, options);
    };
    return wrong;
}

}  // namespace

TEST_CASE("a step in Lie-Poisson form is that of its scheme on T*SO(3)", "[one_step][lie_poisson]") {
    int seen = 0;
    for (const Method& method : methods()) {
        if (!method.factory.takes_actions || !method.factory.scheme) continue;
        INFO(method.description.name);
        for (OptionValues options : scheme_variants(method)) {
            options.merge(stepping::default_options(method.description.options));
            const auto apart = deviation(method, options, "SO3-LiePoisson");
            if (!apart) continue;
            ++seen;
            CHECK(*apart <= 1000 * one_step_tolerance());
        }
    }
    CHECK(seen >= 100);
}

TEST_CASE("a step that adds to velocities is not", "[one_step][lie_poisson][control]") {
    for (const char* name : {"rkmk/heun", "rkmk/rk4", "crouch_grossman/cg3a", "commutator_free/cf4", "rkmk/mk3"}) {
        INFO(name);
        const OptionValues options = stepping::default_options(method(name).description.options);
        CHECK(*deviation(method(name), options, "SO3") > Real(1) / 100000);
    }
}

TEST_CASE("implicit and multistep methods that add to velocities do not step in Lie-Poisson form",
          "[one_step][lie_poisson][control]") {
    for (const char* name : {"rkmk/implicit_midpoint", "rkmk/gauss2", "rkmk/radau2a2", "multistep/adams_bashforth2",
                             "multistep/adams_moulton2"}) {
        INFO(name);
        CHECK_THAT(one_step_objection(additive(method(name))), Catch::EndsWith("as SO3-LiePoisson"));
    }
}

}  // namespace lie_poisson_steps
