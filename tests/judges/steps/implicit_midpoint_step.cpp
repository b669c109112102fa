// SPDX-License-Identifier: BSD-3-Clause
#include "tests/judges/steps/dense_states.hpp"
#include "tests/judges/steps/step_checks.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// y+ = y exp(h k), k = F(t + h/2, y exp(h/2 k)) [hairer2006], on every model.
Objection implicit_midpoint_step_objection(const Method& method) {
    for (const models::Named& named : models::for_methods())
        for (const std::string& formulation : models::applicable(named.model)) {
            if (!stepping::runs_on(method, named.model, formulation)) continue;
            const Real h = Real(1) / 512;
            RecordedRun run(method, {}, named.model, formulation, h, 1);
            const RecordedState &before = run.states[0], &after = run.states[1];
            const DenseStates states(run);
            const VecX u = states.increment(before, after);
            const RecordedState middle = states.moved(before, u / 2, before.t + h / 2);
            Violations found;
            found.see("y+ = y exp(h k)", u - h * states.slope(middle));
            const Objection objection = found.objection(1000 * epsilon * max(Real(1), middle.v.cwiseAbs().maxCoeff()));
            if (!objection.empty()) return objection + " on " + named.name + " as " + formulation;
        }
    return "";
}

}  // namespace

KREISEL_STEP_CHECK("rkmk/implicit_midpoint", implicit_midpoint_step_objection);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
