// SPDX-License-Identifier: BSD-3-Clause
//
// NaN and infinity in the dynamics: libraries take them for small errors, for failures, or end the program. Here they
// are a status, or the step is repeated.
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>

#include "peers/equations.hpp"
#include "tests/peers/methods/approach.hpp"
#include "tests/peers/methods/faulty_system.hpp"

using namespace kreisel;
using namespace peers;

namespace {

const std::string top = "forced_heavy_top";

std::vector<Real> non_finite() {
    const Real infinity = std::numeric_limits<Real>::infinity();
    return {std::numeric_limits<Real>::quiet_NaN(), infinity, -infinity};
}

Approach faulty(const std::string& formulation, const Method& entry, const OptionValues& options,
                const FaultySystem::Fault& fault) {
    const Model model = models::standard(top);
    return {model, std::make_unique<FaultySystem>(make_system(model, formulation), fault), entry, options,
            Real(1) / 1000000};
}

/// What speaks against a method whose dynamics are not finite from some solve on, or "".
std::string fault_objection(const std::string& formulation, const Method& entry, const OptionValues& options) {
    for (const Real& value : non_finite())
        for (const long from : {0L, 1L, 5L, 14L, 60L, 61L, 62L, 63L, 150L}) {
            Approach run = faulty(formulation, entry, options, {from, 1L << 40, value});
            const Status status = run.run({4});
            const std::string where = " for " + to_text(value) + " from solve " + std::to_string(from);
            if (status != Status::non_finite) return name(status) + where;
            if (!run.finite()) return "a state that is not finite" + where;
        }
    return "";
}

template <class F>
void for_each_variant(F f) {
    for (const Method& entry : baselines())
        for (const OptionValues& options : variants(entry))
            for (const char* formulation : {"SO3", "SO3xR3"}) {
                INFO(entry.description.name << text(options) << " as " << formulation);
                f(formulation, entry, options);
            }
}

}  // namespace

TEST_CASE("dynamics that are not finite from some solve on never end as ok", "[peers]") {
    for_each_variant([](const char* formulation, const Method& entry, const OptionValues& options) {
        CHECK(fault_objection(formulation, entry, options) == "");
    });
}

TEST_CASE("one solve that is not finite does not matter: the step is repeated, or ends the run", "[peers]") {
    for_each_variant([](const char* formulation, const Method& entry, const OptionValues& options) {
        for (const Real& value : non_finite())
            for (const long from : {3L, 40L, 41L, 90L, 91L, 92L}) {
                Approach run = faulty(formulation, entry, options, {from, 1, value});
                INFO(to_double(value) << " in solve " << from);
                const Status status = run.run({1});
                CHECK((status == Status::ok || status == Status::non_finite));
                if (status == Status::ok) CHECK(to_double(error_at_1(top, run)) < 1e-3);
            }
    });
}

TEST_CASE("a state that is not finite is refused at the start", "[peers]") {
    for_each_variant([](const char* formulation, const Method& entry, const OptionValues& options) {
        for (std::size_t i = 0;; ++i) {
            Approach run = faulty(formulation, entry, options, {});
            if (i >= run.y.size()) break;
            run.y[i] = std::numeric_limits<Real>::quiet_NaN();
            CHECK(run.run({1}) == Status::non_finite);
        }
    });
}

TEST_CASE("a tolerance that cannot be reached is a status", "[peers]") {
    for_each_variant([](const char* formulation, const Method& entry, const OptionValues& options) {
        const Model model = models::standard(top);
        Approach run(model, formulation, entry, options, pow(Real(10), -60));
        const Status status = run.run({1}, 20000);
        INFO(name(status));
        CHECK((status == Status::step_too_small || status == Status::newton_failed));
    });
}

namespace {

/// Dormand and Prince's pair as Odeint's manual uses it.
class TrustingStepper final : public Stepper {
  public:
    TrustingStepper(System& system, const Accuracy& accuracy)
        : equations_(system, accuracy),
          stepper_(Dopri5::error_checker_type(accuracy.tolerance, Real(0))),
          unknowns_(equations_.size()) {}
    Status start(const Real& t, const Real& t_end, const Real* y) override {
        h_ = Real(1) / 100;
        return equations_.start(t, t_end - t, y, unknowns_.data());
    }
    Status step(Real& t, const Real& limit, Real* y) override {
        const auto derivative = [this](const State& u, State& du, const Real& s) {
            equations_.derivative(s, u.data(), du.data());
        };
        h_ = min(h_, Real(limit - t));
        while (stepper_.try_step(derivative, unknowns_, t, h_) != boost::numeric::odeint::success) continue;
        equations_.write(unknowns_.data(), y);
        return Status::ok;
    }
    std::string failed_part() const override { return ""; }
    const Work& work() const override { return work_; }
    const Real& proposed() const { return h_; }

  private:
    using State = std::vector<Real>;
    using Dopri5 =
        boost::numeric::odeint::controlled_runge_kutta<boost::numeric::odeint::runge_kutta_dopri5<State, Real>>;
    PeerEquations equations_;
    Dopri5 stepper_;
    State unknowns_;
    Real h_ = 0;
    Work work_;
};

}  // namespace

TEST_CASE("control: a stepper that trusts its library is caught", "[peers][control]") {
    Method control = method("baseline/odeint_dopri5");
    control.factory.stepper = [](System& system, Projection&, const Accuracy& accuracy, const OptionValues&,
                                 const MethodDescription&) {
        return std::make_unique<TrustingStepper>(system, accuracy);
    };
    CHECK(fault_objection("SO3", control, {}) != "");
}

TEST_CASE("control: the library accepts NaN, and enlarges the step", "[peers][control]") {
    const Model model = models::standard(top);
    FaultySystem system(make_system(model, "SO3"), {8, 1L << 40, std::numeric_limits<Real>::quiet_NaN()});
    TrustingStepper stepper(system, {Real(1) / 1000000, 1, "pi"});
    std::vector<Real> y = initial_state(system, model);
    Real t = 0;
    REQUIRE(stepper.start(t, 1, y.data()) == Status::ok);
    for (int i = 0; i < 3; ++i) REQUIRE(stepper.step(t, 1, y.data()) == Status::ok);
    CHECK_FALSE(isfinite(y[0]));
    CHECK(stepper.proposed() > Real(1) / 10);
}
