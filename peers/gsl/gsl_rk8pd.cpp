// SPDX-License-Identifier: GPL-3.0-or-later
//
// Baseline: Prince and Dormand's pair of orders 8 and 7 [hairer1993, Sec. II.5] on quaternions, with the step control
// of GSL. The result of order 8 is advanced.
#include "peers/double_only.hpp"
#if !KREISEL_QUAD
#include "peers/gsl/evolution.hpp"
#endif

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

#if KREISEL_QUAD
Factory gsl_rk8pd() { return double_only("baseline/gsl_rk8pd"); }
#else
Factory gsl_rk8pd() { return gsl_evolution(gsl_odeiv2_step_rk8pd, 13, 8); }
#endif

}  // namespace

KREISEL_METHOD(gsl_rk8pd(), {.name = "baseline/gsl_rk8pd",
                             .order = 8,
                             .cites = {"hairer1993", "gsl"},
                             .summary = "Prince-Dormand 8(7) of GSL on quaternions, with its step control",
                             .own_control = true,
                             .formulations = {"SO3", "SO3xR3"}});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
