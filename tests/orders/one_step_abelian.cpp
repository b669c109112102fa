// SPDX-License-Identifier: BSD-3-Clause
//
// On R^n every method with a scheme is its classical counterpart: the tableau can be read off a running step, and steps
// are those of Boost.Odeint: with its own coefficients where it has the rule, with the declared ones everywhere.
#include <boost/array.hpp>
#include <boost/numeric/odeint/stepper/euler.hpp>
#include <boost/numeric/odeint/stepper/explicit_generic_rk.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_cash_karp54.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <catch2/catch.hpp>

#include "methods/contract/integrator.hpp"
#include "tests/judges/families/scheme_family.hpp"
#include "tests/judges/steps/scripted_system.hpp"

using namespace kreisel;

namespace {

OptionValues standard_options(const Method& method) { return with_defaults({}, method.description.options); }

/// Unit vectors: stage velocities and the final velocity are then rows of the tableau.
std::vector<VecX> marks(int stages) {
    std::vector<VecX> script;
    for (int i = 0; i < stages; ++i) script.push_back(VecX::Unit(stages, i));
    return script;
}

ClassicalScheme classical_of(const Method& method) {
    return family_of(*method.factory.scheme)->classical(*method.factory.scheme);
}

/// Within `slack`: not every method with a tableau steps by its rows.
void check_row(const std::vector<Real>& row, const VecX& found, const Real& slack) {
    for (Eigen::Index j = 0; j < found.size(); ++j) {
        const auto k = static_cast<std::size_t>(j);
        CHECK(abs(found[j] - (k < row.size() ? row[k] : Real(0))) <= slack);
    }
}

/// x'' = f(t, x, x'), nonlinear and time-dependent, in two unknowns.
class Oscillator final : public System {
  public:
    Oscillator() : System(std::make_shared<AdditiveGroup>(2)) {}
    Status accelerations(const Real& t, const Real* x, const Real* v, Real* dv, Real*) override {
        dv[0] = -x[0] * x[0] * x[1] + v[1] + sin(t);
        dv[1] = x[0] - v[0] * v[1] + cos(3 * t) * x[1];
        return Status::ok;
    }
};

using State = std::vector<Real>;
const State initial = {1, Real(1) / 3, Real(-1) / 2, Real(2) / 5};
const Real h = Real(1) / 10;
constexpr int steps = 10;

State ours(const Method& method, const OptionValues& options) {
    Oscillator system;
    const auto integrator = method.bind(system, options);
    State y = initial;
    for (int step = 0; step < steps; ++step) REQUIRE(integrator->step(step * h, h, y.data()) == Status::ok);
    return y;
}

template <class Stepper>
State theirs(Stepper stepper) {
    Oscillator system;
    const auto field = [&](const State& y, State& dy, const Real& t) {
        REQUIRE(system.vector_field(t, y.data(), dy.data()) == Status::ok);
    };
    State y = initial;
    for (int step = 0; step < steps; ++step) stepper.do_step(field, y, step * h, h);
    return y;
}

/// Up to round-off, of steps whose coefficients sum to `size`.
void check_equal(const State& a, const State& b, const Real& size = 1) {
    REQUIRE(a.size() == b.size());
    for (std::size_t i = 0; i < a.size(); ++i) CHECK(abs(a[i] - b[i]) < 64 * epsilon * size);
}

/// Row k of the coefficients a, from 0.
template <std::size_t k>
boost::array<Real, k> row(const ClassicalScheme& scheme) {
    boost::array<Real, k> entries;
    for (std::size_t j = 0; j < k; ++j) entries[j] = j < scheme.a[k].size() ? scheme.a[k][j] : Real(0);
    return entries;
}

/// Odeint's explicit Runge-Kutta step of s stages with any coefficients.
template <std::size_t s, std::size_t... k>
State generic(const ClassicalScheme& scheme, std::index_sequence<k...>) {
    using Stepper = boost::numeric::odeint::explicit_generic_rk<s, s, State, Real, State, Real>;
    typename Stepper::coef_b_type b;
    typename Stepper::coef_c_type c;
    for (std::size_t i = 0; i < s; ++i) {
        b[i] = i < scheme.b.size() ? scheme.b[i] : Real(0);
        c[i] = 0;
        for (const Real& entry : scheme.a[i]) c[i] += entry;
    }
    return theirs(Stepper(typename Stepper::coef_a_type(row<k + 1>(scheme)...), b, c));
}

constexpr std::size_t most_stages = 13;  // of which Odeint is capable

template <std::size_t s = 1>
State classical(const ClassicalScheme& scheme) {
    if (scheme.a.size() == s) return generic<s>(scheme, std::make_index_sequence<s - 1>());
    if constexpr (s < most_stages) return classical<s + 1>(scheme);
    return {};
}

}  // namespace

TEST_CASE("the running step on R^n shows the declared tableau", "[one_step]") {
    for (const Method& method : methods()) {
        if (!method.factory.scheme) continue;
        INFO(method.description.name);
        const ClassicalScheme scheme = classical_of(method);  // it may have stages that only an attempt takes
        const Real slack = 4 * epsilon * magnitude(scheme);
        const int s = method.description.stages;
        ScriptedSystem system(std::make_shared<AdditiveGroup>(s), marks(s));
        VecX y = VecX::Zero(2 * s);
        const auto integrator = method.bind(system, standard_options(method));
        REQUIRE(integrator->step(Real(0), Real(1), y.data()) == Status::ok);
        REQUIRE(system.calls().size() == static_cast<std::size_t>(s));
        CHECK(system.evaluations() == s);
        for (std::size_t i = 0; i < static_cast<std::size_t>(s); ++i) {
            INFO("row " << i + 1);
            check_row(scheme.a[i], system.calls()[i].v, slack);
            Real c = 0;
            for (const Real& entry : scheme.a[i]) c += entry;
            CHECK(abs(system.calls()[i].t - c) <= slack);
        }
        check_row(scheme.b, y.tail(s), slack);
    }
}

TEST_CASE("every method with a scheme is on R^n the generic Runge-Kutta method of Boost.Odeint", "[one_step]") {
    int compared = 0;
    for (const Method& method : methods()) {
        if (!method.factory.scheme) continue;
        INFO(method.description.name);
        const ClassicalScheme scheme = classical_of(method);
        if (scheme.a.size() > most_stages) continue;  // the case above has seen its coefficients
        check_equal(ours(method, standard_options(method)), classical(scheme), magnitude(scheme));
        ++compared;
    }
    CHECK(compared >= 25);
}

TEST_CASE("where Boost.Odeint has coefficients of its own, they are the declared ones", "[one_step]") {
    using namespace boost::numeric::odeint;
    for (const auto* coordinates : {"exp", "cayley"}) {
        const auto options = [&](const Method& entry) {
            OptionValues values = standard_options(entry);
            values["coordinates"] = coordinates;
            return values;
        };
        check_equal(ours(method("rkmk/rk4"), options(method("rkmk/rk4"))),
                    theirs(runge_kutta4<State, Real, State, Real>()));
        check_equal(ours(method("rkmk/euler"), options(method("rkmk/euler"))),
                    theirs(euler<State, Real, State, Real>()));
        const auto compare_pair = [&](const char* name, const State& expected) {
            check_equal(ours(method(name), options(method(name))), expected, magnitude(classical_of(method(name))));
        };
        compare_pair("rkmk/cash_karp5", theirs(runge_kutta_cash_karp54<State, Real, State, Real>()));
        compare_pair("rkmk/dopri5", theirs(runge_kutta_dopri5<State, Real, State, Real>()));
        compare_pair("rkmk/fehlberg8", theirs(runge_kutta_fehlberg78<State, Real, State, Real>()));
    }
}
