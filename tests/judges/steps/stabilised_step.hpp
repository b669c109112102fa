// SPDX-License-Identifier: BSD-3-Clause
//
// One-step checks of the stabilised index-2 methods.
#pragma once

#include "tests/judges/methods/checks.hpp"
#include "tests/judges/steps/recorded_steps.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Equations of the stabilised index-2 methods; modified if a control requires it. The sign of eta is
/// a convention: eta is unknown and not reported, so only the space spanned by its term can be checked.
struct StabilisedForm {
    DenseBodies::Side side = DenseBodies::Side::right;  ///< left: q+ = exp(h D) q
    bool eta_from_end = false;                          ///< M^{-1} C(q+)^T eta for M^{-1} C(q)^T eta
    bool eta_without_mass = false;                      ///< C(q)^T eta, as in the literature
    bool without_eta = false;
    bool multipliers_negated = false;  ///< M v' = Q + C^T lambda
    int sign_of_previous = 1;          ///< of D_previous, BLieDF only
    bool start_at_rate = false;        ///< a(0) = v'(0), generalised-alpha only
};

/// methods/generalized_alpha/index2.cpp, three steps from its own start [bruels2012], [arnold2016].
Objection generalised_alpha_step_objection(const Method&, const StabilisedForm& form = {});
/// methods/multistep/bliedf2.cpp, three steps from its own start [wieloch2021].
Objection bliedf2_step_objection(const Method&, const StabilisedForm& form = {});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
