// SPDX-License-Identifier: BSD-3-Clause
//
// Baseline: the predictor-corrector of Adams, Bashforth and Moulton in divided differences [hairer1993, Sec. III.5] on
// quaternions, with the control of order (1 to 8) and step of Boost.Odeint.
#include "peers/double_only.hpp"
#if !KREISEL_QUAD
#include <boost/numeric/odeint/stepper/controlled_adams_bashforth_moulton.hpp>
#include <limits>

#include "peers/odeint/controlled.hpp"
#endif

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

#if KREISEL_QUAD

Factory odeint_adams() { return double_only("baseline/odeint_adams_bashforth_moulton"); }

#else

using OdeintAdams = boost::numeric::odeint::controlled_adams_bashforth_moulton<
    boost::numeric::odeint::adaptive_adams_bashforth_moulton<8, OdeintState>>;

Factory odeint_adams() {
    // Without a largest step, which is 1 s by default.
    const auto make = [](const Real& tolerance) {
        return OdeintAdams(OdeintAdams::step_adjuster_type(tolerance, 0, std::numeric_limits<double>::infinity()));
    };
    return odeint<OdeintAdams>(make, 2, 2);
}

#endif

}  // namespace

KREISEL_METHOD(odeint_adams(),
               {.name = "baseline/odeint_adams_bashforth_moulton",
                .order = 8,
                .cites = {"hairer1993", "ahnert2011"},
                .summary = "Adams-Bashforth-Moulton of Boost.Odeint on quaternions, orders 1 to 8, with "
                           "its step control",
                .own_control = true,
                .projectable = false,
                .formulations = {"SO3", "SO3xR3"}});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
