// SPDX-License-Identifier: BSD-3-Clause
#include "tests/judges/steps/recorded_steps.hpp"
#include "tests/judges/steps/step_checks.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// V = (v + v+)/2, q+ = q exp(h V), v+ = v + h v'(t + h/2, q exp(h/2 V), V) [hairer2006], on every model.
Objection implicit_midpoint_step_objection(const Method& method) {
    for (const models::Named& named : models::for_methods())
        for (const std::string& formulation : models::applicable(named.model)) {
            if (!stepping::runs_on(method, named.model, formulation)) continue;
            const Real h = Real(1) / 512;
            RecordedRun run(method, {}, named.model, formulation, h, 1);
            const RecordedState &before = run.states[0], &after = run.states[1];
            const VecX V = (before.v + after.v) / 2;
            const RecordedState middle = {
                .t = before.t + h / 2, .q = run.bodies.moved(before.q, h / 2 * V), .v = V, .lambda = {}};
            Violations found;
            found.see("q+ = q exp(h V)", run.bodies.increment(before.q, after.q) - h * V);
            found.see("v+ = v + h v'", after.v - before.v - h * run.index1_rate(middle));
            const Objection objection = found.objection(1000 * epsilon * max(Real(1), V.cwiseAbs().maxCoeff()));
            if (!objection.empty()) return objection + " on " + named.name + " as " + formulation;
        }
    return "";
}

}  // namespace

KREISEL_STEP_CHECK("rkmk/implicit_midpoint", implicit_midpoint_step_objection);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
