// SPDX-License-Identifier: BSD-3-Clause
//
// One-step checks of the methods with the index-3 and the stabilised index-2 form.
#pragma once

#include "tests/judges/methods/checks.hpp"
#include "tests/judges/steps/recorded_steps.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Equations of the methods with constraints; modified if a control requires it. The sign of eta is
/// a convention: eta is unknown and not reported, so only the space spanned by its term can be checked.
struct StabilisedForm {
    DenseBodies::Side side = DenseBodies::Side::right;  ///< left: q+ = exp(h D) q
    bool eta_from_end = false;                          ///< M^{-1} C(q+)^T eta for M^{-1} C(q)^T eta
    bool eta_without_mass = false;                      ///< C(q)^T eta, as in the literature
    bool without_eta = false;
    bool positions_alone = false;      ///< the index-3 form, in which C v + b = 0 is not met; BLieDF only
    bool multipliers_negated = false;  ///< M v' = Q + C^T lambda
    int sign_of_previous = 1;          ///< of the increments before, BLieDF only
    int sign_of_bracket = 1;           ///< of [v, v']
    bool start_at_rate = false;        ///< a(0) = v'(0), generalised-alpha only
    bool unperturbed = false;          ///< v(0) for v(0) + Delta, index-3 form only
};

/// methods/generalized_alpha/index2.cpp and index3.cpp, three steps from their own start [bruels2012], [arnold2015].
Objection generalised_alpha_step_objection(const Method&, const StabilisedForm& form = {});
Objection position_alpha_step_objection(const Method&, const StabilisedForm& form = {});
/// methods/multistep/bliedf.hpp with k steps, four steps from its own start [wieloch2021].
Objection bliedf_step_objection(const Method&, int k, const StabilisedForm& form = {});

/// What these have in common: q+ satisfies Phi = 0; q+, v+ satisfy C v + b = 0.
void see_positions(RecordedRun& run, const RecordedState& state, Violations& found);
void see_velocities(RecordedRun& run, const RecordedState& state, Violations& found);
/// The part of r outside the range of the eta term of a step.
VecX without_eta_term(RecordedRun& run, const StabilisedForm& form, std::size_t step, const VecX& r);
/// v' at the end of a step, by its multipliers.
VecX rate_at_end(RecordedRun& run, const StabilisedForm& form, const RecordedState& state);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
