// SPDX-License-Identifier: BSD-3-Clause
//
// Baseline: extrapolation of the modified midpoint rule [gragg1965], [bulirschstoer1966] on quaternions, with the
// control of order and step of Boost.Odeint: order 2 (k + 1) with k from 2 to 8.
#include "peers/double_only.hpp"
#if !KREISEL_QUAD
#include <boost/numeric/odeint/stepper/bulirsch_stoer.hpp>

#include "peers/odeint/controlled.hpp"
#endif

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

#if KREISEL_QUAD

Factory odeint_bulirsch_stoer() { return double_only("baseline/odeint_bulirsch_stoer"); }

#else

using OdeintBulirschStoer = boost::numeric::odeint::bulirsch_stoer<OdeintState, Real>;

OdeintBulirschStoer odeint_bulirsch_stoer_to(const Real& tolerance) {
    return OdeintBulirschStoer(tolerance, Real(0), Real(1), Real(1), Real(0));
}

Factory odeint_bulirsch_stoer() { return odeint<OdeintBulirschStoer>(odeint_bulirsch_stoer_to, 0, 8); }

#endif

}  // namespace

KREISEL_METHOD(odeint_bulirsch_stoer(),
               {.name = "baseline/odeint_bulirsch_stoer",
                .order = 18,
                .cites = {"gragg1965", "bulirschstoer1966", "ahnert2011"},
                .summary = "Bulirsch-Stoer of Boost.Odeint on quaternions, up to order 18, with its step control",
                .own_control = true,
                .formulations = {"SO3", "SO3xR3"}});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
