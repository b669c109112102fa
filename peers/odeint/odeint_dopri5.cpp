// SPDX-License-Identifier: BSD-3-Clause
//
// Baseline: Dormand and Prince's pair of orders 5 and 4 [hairer1993, Table II.5.2] on quaternions, with the step
// control of Boost.Odeint. The result of order 5 is advanced.
#include "peers/double_only.hpp"
#if !KREISEL_QUAD
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>

#include "peers/odeint/controlled.hpp"
#endif

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

#if KREISEL_QUAD

Factory odeint_dopri5() { return double_only("baseline/odeint_dopri5"); }

#else

using OdeintDopri5 =
    boost::numeric::odeint::controlled_runge_kutta<boost::numeric::odeint::runge_kutta_dopri5<OdeintState, Real>>;

OdeintDopri5 odeint_dopri5_to(const Real& tolerance) {
    return OdeintDopri5(OdeintDopri5::error_checker_type(tolerance, Real(0)));
}

Factory odeint_dopri5() { return odeint<OdeintDopri5>(odeint_dopri5_to, 6, 5); }

#endif

}  // namespace

KREISEL_METHOD(odeint_dopri5(), {.name = "baseline/odeint_dopri5",
                                 .order = 5,
                                 .cites = {"hairer1993", "ahnert2011"},
                                 .summary = "Dormand-Prince 5(4) of Boost.Odeint on quaternions, with its step control",
                                 .own_control = true,
                                 .formulations = {"SO3", "SO3xR3"}});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
