// SPDX-License-Identifier: BSD-3-Clause
//
// Implicit methods on R, where they are the classical ones, and what ends without a solution there.
#include <array>
#include <cmath>

#include "tests/methods/stepping.hpp"

namespace implicit_on_a_line {

using namespace kreisel;
using namespace models;
using namespace stepping;

namespace {

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

}  // namespace implicit_on_a_line
