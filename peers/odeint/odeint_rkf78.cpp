// SPDX-License-Identifier: BSD-3-Clause
//
// Baseline: Fehlberg's pair of orders 7 and 8 [hairer1993, Sec. II.10] on quaternions, with the step control of
// Boost.Odeint. The result of order 8 is advanced. The pair's error estimate 41/840 h (k_1 + k_11 - k_12 - k_13)
// vanishes where f depends on t only.
#include "peers/double_only.hpp"
#if !KREISEL_QUAD
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>

#include "peers/odeint/controlled.hpp"
#endif

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

#if KREISEL_QUAD

Factory odeint_rkf78() { return double_only("baseline/odeint_rkf78"); }

#else

using OdeintRkf78 =
    boost::numeric::odeint::controlled_runge_kutta<boost::numeric::odeint::runge_kutta_fehlberg78<OdeintState, Real>>;

OdeintRkf78 odeint_rkf78_to(const Real& tolerance) {
    return OdeintRkf78(OdeintRkf78::error_checker_type(tolerance, Real(0)));
}

Factory odeint_rkf78() { return odeint<OdeintRkf78>(odeint_rkf78_to, 13, 8); }

#endif

}  // namespace

KREISEL_METHOD(odeint_rkf78(), {.name = "baseline/odeint_rkf78",
                                .order = 8,
                                .cites = {"hairer1993", "ahnert2011"},
                                .summary = "Fehlberg 7(8) of Boost.Odeint on quaternions, with its step control",
                                .own_control = true,
                                .formulations = {"SO3", "SO3xR3"}});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
