// SPDX-License-Identifier: BSD-3-Clause
//
// Judgements of schemes and steps; no method is passed over in silence. See tests/judges/methods/checks.hpp.
#pragma once

#include "tests/judges/methods/checks.hpp"
#include "tests/judges/steps/dense.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// The order conditions of the scheme's family (tests/judges/families/) hold up to the declared order and not beyond,
/// and so do those of the declared estimate of the error. An explicit method must declare a scheme, or be exempt with a
/// reason (step_checks.hpp).
Objection order_conditions_objection(const Method&);

/// One step, and one attempt where an estimate is declared, with scripted, non-commuting slopes equals an evaluation of
/// the declared scheme by dense matrices, on SO(3) and SE(3), with every combination of options that changes the
/// scheme. A method without a scheme must be known to a step check of its own (step_checks.hpp).
Objection one_step_objection(const Method&);

/// Round-off of about ten matrix products; of a scheme with large coefficients, times their magnitude.
inline Real one_step_tolerance() { return KREISEL_QUAD ? from_text("1e-30") : from_text("1e-14"); }
/// Options that change the scheme of a method, every combination; one empty set if there are none.
std::vector<OptionValues> scheme_variants(const Method&);
/// Largest difference of the results of one step under two sets of options.
Real one_step_difference(const Method&, const OptionValues&, const OptionValues&, const MatrixGroup&);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
