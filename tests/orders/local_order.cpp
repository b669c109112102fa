// SPDX-License-Identifier: BSD-3-Clause
//
// The running code has the order that the generated conditions predict for its tableau and its products, so the
// conditions belong to this trivialisation and this order of factors. Measured as the local error of one
// step against Boost.Odeint's Runge-Kutta-Fehlberg method of order 8 on the entries of the rotation matrix. In quad
// only: where the local slopes of order 4 have settled, double has only round-off left.
#include "lie/real.hpp"

#if KREISEL_QUAD

#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <catch2/catch.hpp>
#include <cmath>

#include "lie/power.hpp"
#include "lie/so3.hpp"
#include "mechanics/system.hpp"
#include "methods/contract/integrator.hpp"
#include "tests/controls/controls.hpp"
#include "tests/judges/conditions/crouch_grossman_conditions.hpp"
#include "tests/judges/conditions/registered.hpp"

using namespace kreisel;
using namespace kreisel::orders;

namespace {

using State = std::vector<Real>;

/// A forced asymmetric body: does not commute, depends on R and on time. R column by column.
void acceleration(const Real& t, const Real* R, const Real* w, Real* dw) {
    const Real force = 1 + sin(5 * t) / 2;
    dw[0] = Real(3) / 4 * w[1] * w[2] + force * (R[2] - R[5] / 3);
    dw[1] = -Real(1) / 2 * w[2] * w[0] + force * (R[8] / 2 + R[2]);
    dw[2] = Real(1) / 5 * w[0] * w[1] - force * R[5] + cos(t) / 4;
}

/// Only its accelerations are known, no momenta or forces.
class ForcedBody final : public System {
  public:
    ForcedBody() : System(std::make_shared<Power<SO3>>(1)) {}
    Status accelerations(const Real& t, const Real* q, const Real* v, Real* dv, Real*) override {
        acceleration(t, q, v, dv);
        return Status::ok;
    }
    bool is_dissipative() const override { return true; }
};

const Real start_time = Real(1) / 3;

State start() {
    State y(12, Real(0));
    const Real u[3] = {Real(1) / 2, Real(-2) / 3, Real(1) / 5};
    Power<SO3> group(1);
    group.identity(y.data());
    group.append_exp(y.data(), u, y.data());
    y[9] = 1, y[10] = Real(-7) / 10, y[11] = Real(6) / 5;
    return y;
}

/// R' = R hat(w) entry by entry: row r of R turns into R_r x w.
void field(const State& y, State& dy, const Real& t) {
    for (std::size_t r = 0; r < 3; ++r) {
        const Real a = y[r], b = y[3 + r], c = y[6 + r];
        dy[r] = b * y[11] - c * y[10];
        dy[3 + r] = c * y[9] - a * y[11];
        dy[6 + r] = a * y[10] - b * y[9];
    }
    acceleration(t, y.data(), &y[9], &dy[9]);
}

State exact_flow(const Real& h) {
    State y = start();
    boost::numeric::odeint::runge_kutta_fehlberg78<State, Real, State, Real> reference;
    const int substeps = 8;
    for (int i = 0; i < substeps; ++i) reference.do_step(field, y, start_time + i * h / substeps, h / substeps);
    return y;
}

double local_error(const Method& method, const OptionValues& options, const Real& h) {
    ForcedBody body;
    State y = start();
    const auto integrator = method.bind(body, with_defaults(options, method.description.options));
    REQUIRE(integrator->step(start_time, h, y.data()) == Status::ok);
    const State exact = exact_flow(h);
    Real sum = 0;
    for (std::size_t i = 0; i < y.size(); ++i) sum += (y[i] - exact[i]) * (y[i] - exact[i]);
    return to_double(sqrt(sum));
}

/// Local slopes log2(e(h)/e(h/2)) - 1 must lie within 0.1 of `order`, 0.2 from order 6, for three consecutive halvings.
/// A step of high order is down at round-off sooner.
void check_order(const Method& method, const OptionValues& options, int order) {
    const bool high = order >= 6;
    Real h = Real(1) / (high ? 32 : 128);
    double error = local_error(method, options, h);
    for (int halving = 0; halving < 3; ++halving) {
        h /= 2;
        const double next = local_error(method, options, h);
        INFO(method.description.name << " at h = " << to_double(h));
        CHECK(std::log2(error / next) - 1 == Approx(order).margin(high ? 0.2 : 0.1));
        error = next;
    }
}

OptionValues with(const std::string& coordinates, const OptionValue& dexpinv) {
    return {{"coordinates", coordinates}, {"dexpinv", dexpinv}};
}

}  // namespace

TEST_CASE("Crouch-Grossman steps have the order that their conditions predict", "[local_order]") {
    for (const Method* method : registered<CrouchGrossmanScheme>()) {
        const Tableau& tableau = scheme_of<CrouchGrossmanScheme>(*method)->tableau;
        check_order(*method, {}, crouch_grossman_order(exact(tableau), rounding(tableau)));
    }
}

TEST_CASE("Munthe-Kaas steps have the order of their tableau", "[local_order]") {
    for (const Method* method : registered<MuntheKaasScheme>()) {
        const int order = method->description.order.configuration;
        if (method->description.options.empty()) {
            check_order(*method, {}, order);
            continue;
        }
        for (const auto& options :
             {with("exp", "exact"), with("exp", "seed"), with("cayley", "exact"), with("second_kind", "exact")})
            check_order(*method, options, order);
    }
}

TEST_CASE("dexpinv cut after q brackets allows order q + 2", "[local_order]") {
    for (long q = 0; q <= 3; ++q) check_order(method("rkmk/rk4"), with("exp", q), std::min(4, static_cast<int>(q) + 2));
    for (long q = 0; q <= 3; ++q)
        check_order(method("rkmk/kutta3"), with("exp", q), std::min(3, static_cast<int>(q) + 2));
}

TEST_CASE("controls have the order that their fault leaves", "[local_order]") {
    ForcedBody body;
    for (const Control& control : controls()) {
        const auto& declines = control.method.factory.declines;
        if (control.claims_too_much() || (declines && !declines(body).empty())) continue;
        check_order(control.method, {}, control.true_order);
    }
}

#endif
