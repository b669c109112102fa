// SPDX-License-Identifier: BSD-3-Clause
//
// NaN and infinity in the dynamics: libraries take them for small errors, for failures, or end the program. Here they
// are a status, or the step is repeated.
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>

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
        for (const Real& value : non_finite())
            for (const long from : {0L, 1L, 5L, 14L, 60L, 61L, 62L, 63L, 150L}) {
                Approach run = faulty(formulation, entry, options, {from, 1L << 40, value});
                INFO(to_double(value) << " from solve " << from);
                CHECK(run.run({4}) == Status::non_finite);
                CHECK(run.finite());
            }
    });
}

TEST_CASE("one solve that is not finite is no matter: the step is repeated, or ends the run", "[peers]") {
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

TEST_CASE("control: by itself the library accepts NaN and enlarges the step", "[peers][control]") {
    using State = std::vector<Real>;
    using Dopri5 =
        boost::numeric::odeint::controlled_runge_kutta<boost::numeric::odeint::runge_kutta_dopri5<State, Real>>;
    Dopri5 stepper(Dopri5::error_checker_type(Real(1) / 1000000, Real(0)));
    State u = {1};
    Real t = 0, h = Real(1) / 100;
    const auto spoiled = [](const State&, State& du, const Real&) { du[0] = std::numeric_limits<Real>::quiet_NaN(); };
    CHECK(stepper.try_step(spoiled, u, t, h) == boost::numeric::odeint::success);
    CHECK(t > 0);
    CHECK(h > Real(1) / 100);
    CHECK_FALSE(isfinite(u[0]));
}
