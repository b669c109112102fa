// SPDX-License-Identifier: BSD-3-Clause
//
// RATTLie and SHAKELie: residuals of the published equations [hantearnold2021] for the steps of a run, with dense
// differentials. The multipliers at the beginning of a step of RATTLie are not reported, so only the space spanned by
// their term is checked.
#include "tests/judges/steps/dense_increments.hpp"
#include "tests/judges/steps/step_checks.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

Violations rattlie_violations(RecordedRun& run, const DenseIncrements& dense) {
    Violations found;
    for (std::size_t i = 0; i + 1 < run.states.size(); ++i) {
        const RecordedState &now = run.states[i], &next = run.states[i + 1];
        const Real& h = run.h;
        const MatX M = run.mass(now.q), C = run.position_rows(now), C_next = run.position_rows(next);
        const VecX u = dense.coordinates(run.bodies.increment(now.q, next.q)), p = M * u / h;
        const VecX first = dense.transposed(-u) * p - M * now.v - h / 2 * force_at_rest(run, now);
        found.see("p at the beginning", outside_range(C.transpose(), first));
        VecX second = dense.transposed(u) * p + h / 2 * force_at_rest(run, next) - M * next.v;
        if (C_next.rows() > 0) second -= h / 2 * C_next.transpose() * next.lambda;
        found.see("p+ at the end", second);
        found.see("Phi(q+) = 0", run.position_defect(next));
        found.see("C(q+) v+ + b = 0", run.velocity_defect(next));
    }
    return found;
}

/// The momenta that the increments before and after a state leave at it, and the impulse between them.
Violations shakelie_violations(RecordedRun& run, const DenseIncrements& dense) {
    Violations found;
    const Real& h = run.h;
    VecX before;  // (d tau^{-1}_{-hD})^T M D of the step before
    for (std::size_t i = 0; i < run.states.size(); ++i) {
        const RecordedState& now = run.states[i];
        const MatX M = run.mass(now.q), C = run.position_rows(now);
        VecX impulse = h * force_at_rest(run, now);
        if (i > 0) {
            if (C.rows() > 0) impulse -= h * C.transpose() * now.lambda;
            found.see("M v+, half of the impulse", before + impulse / 2 - M * now.v);
            found.see("Phi(q+) = 0", run.position_defect(now));
        }
        if (i + 1 == run.states.size()) break;
        const VecX u = dense.coordinates(run.bodies.increment(now.q, run.states[i + 1].q)), p = M * u / h;
        const VecX after = dense.transposed(-u) * p;
        if (i == 0) found.see("p at the start", outside_range(C.transpose(), VecX(after - M * now.v - impulse / 2)));
        if (i > 0) found.see("the impulse between increments", after - before - impulse);
        before = dense.transposed(u) * p;
    }
    return found;
}

KREISEL_STEP_CHECK("variational/rattlie",
                   [](const Method& method) { return on_increments(method, 2, rattlie_violations); });
KREISEL_STEP_CHECK("variational/shakelie",
                   [](const Method& method) { return on_increments(method, 3, shakelie_violations); });

}  // namespace

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
