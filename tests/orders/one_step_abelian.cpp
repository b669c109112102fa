// SPDX-License-Identifier: BSD-3-Clause
//
// On R^n every method is its classical counterpart: the tableau can be read off a running step, and the lift of the
// classical fourth-order rule is the one of Boost.Odeint.
#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>
#include <catch2/catch.hpp>

#include "methods/bound_tableau.hpp"
#include "methods/integrator.hpp"
#include "tests/orders/scripted_system.hpp"

using namespace kreisel;

namespace {

OptionValues standard_options(const Method& method) {
    OptionValues options;
    for (const auto& option : method.description.options) options[option.name] = option.standard;
    return options;
}

/// Unit vectors: stage velocities and the final velocity are then rows of the tableau.
std::vector<VecX> marks(int stages) {
    std::vector<VecX> script;
    for (int i = 0; i < stages; ++i) script.push_back(VecX::Unit(stages, i));
    return script;
}

void check_row(const std::vector<Coefficient>& row, const VecX& found) {
    for (Eigen::Index j = 0; j < found.size(); ++j) {
        const auto k = static_cast<std::size_t>(j);
        CHECK(found[j] == (k < row.size() ? value(row[k]) : Real(0)));
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

}  // namespace

TEST_CASE("the running step on R^n shows the declared tableau", "[one_step]") {
    for (const Method& method : methods()) {
        if (!method.factory.scheme) continue;
        INFO(method.description.name);
        const Tableau& tableau = method.factory.scheme->tableau;
        const int s = method.description.stages;
        ScriptedSystem system(std::make_shared<AdditiveGroup>(s), marks(s));
        VecX y = VecX::Zero(2 * s);
        const auto integrator = method.factory.make(system, standard_options(method), method.description);
        REQUIRE(integrator->step(Real(0), Real(1), y.data()) == Status::ok);
        REQUIRE(system.calls().size() == tableau.a.size());
        CHECK(system.evaluations() == s);
        for (std::size_t i = 0; i < tableau.a.size(); ++i) {
            INFO("row " << i + 1);
            check_row(tableau.a[i], system.calls()[i].v);
            Real c = 0;
            for (const auto& entry : tableau.a[i]) c += value(entry);
            CHECK(system.calls()[i].t == c);
        }
        check_row(tableau.b, y.tail(s));
    }
}

TEST_CASE("rkmk/rk4 on R^n is the classical method of Boost.Odeint", "[one_step]") {
    using State = std::vector<Real>;
    Oscillator system;
    const Method& rk4 = method("rkmk/rk4");
    boost::numeric::odeint::runge_kutta4<State, Real, State, Real> classical;
    const auto field = [&](const State& y, State& dy, const Real& t) {
        REQUIRE(system.vector_field(t, y.data(), dy.data()) == Status::ok);
    };
    for (const auto* coordinates : {"exp", "cayley"}) {
        auto options = standard_options(rk4);
        options["coordinates"] = coordinates;
        const auto integrator = rk4.factory.make(system, options, rk4.description);
        State ours = {1, Real(1) / 3, Real(-1) / 2, Real(2) / 5}, theirs = ours;
        const Real h = Real(1) / 10;
        for (int step = 0; step < 10; ++step) {
            REQUIRE(integrator->step(step * h, h, ours.data()) == Status::ok);
            classical.do_step(field, theirs, step * h, h);
        }
        for (std::size_t i = 0; i < ours.size(); ++i) CHECK(abs(ours[i] - theirs[i]) < 64 * epsilon);
    }
}
