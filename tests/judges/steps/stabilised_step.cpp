// SPDX-License-Identifier: BSD-3-Clause
//
// The methods with constraints on positions: residuals of each published equation for the steps of a run.
// Positions and velocities at the ends of the steps and the reported multipliers are the only data taken from the
// method.
#include "tests/judges/steps/stabilised_step.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

void see_positions(RecordedRun& run, const RecordedState& state, Violations& found) {
    found.see("Phi(q+) = 0", run.position_defect(state));
}

void see_velocities(RecordedRun& run, const RecordedState& state, Violations& found) {
    found.see("C(q+) v+ + b = 0", run.velocity_defect(state));
}

VecX without_eta_term(RecordedRun& run, const StabilisedForm& form, std::size_t step, const VecX& r) {
    if (form.without_eta) return r;
    const RecordedState& state = run.states[form.eta_from_end ? step + 1 : step];
    MatX directions = run.position_rows(state).transpose();
    if (!form.eta_without_mass) run.solve_mass(state.q, directions);
    return outside_range(directions, r);
}

VecX rate_at_end(RecordedRun& run, const StabilisedForm& form, const RecordedState& state) {
    RecordedState end = state;
    if (form.multipliers_negated) end.lambda = -end.lambda;
    return run.rate(end);
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
