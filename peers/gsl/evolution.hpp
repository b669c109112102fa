// SPDX-License-Identifier: GPL-3.0-or-later
//
// Integrators of the GNU Scientific Library [gsl] on quaternions, with its step control: gsl_odeiv2_evolve. It would
// end the program at an error; its handler is global, so it is switched off once and for all, as in
// records/fits/fit.cpp.
#pragma once

#include <gsl/gsl_odeiv2.h>

#include "methods/contract/method.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// `first_order`: the order of the first step; `stages`: solves of the dynamics per attempt, where their number is
/// fixed.
Factory gsl_evolution(const gsl_odeiv2_step_type* type, int stages, int first_order);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
