// SPDX-License-Identifier: GPL-3.0-or-later
//
// Baseline: Adams methods of variable coefficients in Nordsieck form [hairer1993, Sec. III.5, III.6], with a corrector
// by functional iteration, on quaternions, with the control of order (1 to 12) and step of GSL.
#include "peers/double_only.hpp"
#if !KREISEL_QUAD
#include "peers/gsl/evolution.hpp"
#endif

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

#if KREISEL_QUAD
Factory gsl_msadams() { return double_only("baseline/gsl_msadams"); }
#else
Factory gsl_msadams() { return gsl_evolution(gsl_odeiv2_step_msadams, 0, 2); }
#endif

}  // namespace

KREISEL_METHOD(gsl_msadams(), {.name = "baseline/gsl_msadams",
                               .order = 12,
                               .cites = {"hairer1993", "gsl"},
                               .summary = "Adams method of GSL on quaternions, orders 1 to 12, with its step control",
                               .own_control = true,
                               .projectable = false,
                               .formulations = {"SO3", "SO3xR3"}});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
