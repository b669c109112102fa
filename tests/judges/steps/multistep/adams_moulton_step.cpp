// SPDX-License-Identifier: BSD-3-Clause
//
// Adams-Moulton methods on a group [faltinsen2001], written in backward differences of the slopes in the chart around
// the newest state, the slope at the end of the step first: with gamma* = 1, -1/2, -1/12, -1/24, -19/720
// [hairer1993, Sec. III.1],
//   log(y^{-1} y+) = h sum_m gamma*_m nabla^m k~.
#include "tests/judges/steps/multistep/adams_moulton_step.hpp"

#include "tests/judges/steps/dense_states.hpp"
#include "tests/judges/steps/step_checks.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// sum_m gamma*_m nabla^m f for values f_{n+1}, f_n, ...
VecX moulton_sum(std::vector<VecX> f, int differences_left_out) {
    const Real gamma[] = {1, Real(-1) / 2, Real(-1) / 12, Real(-1) / 24, Real(-19) / 720};
    VecX sum = VecX::Zero(f.front().size());
    const std::size_t used = f.size() - static_cast<std::size_t>(differences_left_out);
    for (std::size_t m = 0; m < used; ++m) {
        sum += gamma[m] * f.front();
        for (std::size_t j = 0; j + 1 < f.size(); ++j) f[j] -= f[j + 1];
        f.pop_back();
    }
    return sum;
}

/// `known`: the end of the step, its start, and the k - 1 states before.
void see_moulton_step(RecordedRun& run, const std::vector<RecordedState>& known, const AdamsMoultonForm& form,
                      Violations& found) {
    const RecordedState &next = known[0], &now = known[1];
    const DenseStates states(run);
    std::vector<VecX> slopes;
    for (const RecordedState& state : known) {
        const VecX sigma = form.sign_of_sigma * states.increment(now, state);
        slopes.push_back(form.recentred ? states.pulled_back(sigma, states.slope(state)) : states.slope(state));
    }
    found.see("log(y^-1 y+) = h sum gamma* nabla k~",
              states.increment(now, next) - run.h * moulton_sum(slopes, form.differences_left_out));
}

Violations moulton_violations(RecordedRun& run, int k, const AdamsMoultonForm& form) {
    std::vector<RecordedState> known = {run.states[0]};  // the newest first
    while (static_cast<int>(known.size()) < k) known.push_back(state_before(run, known.back(), "rkmk/verner6"));
    Violations found;
    for (std::size_t i = 1; i < run.states.size(); ++i) {
        known.insert(known.begin(), run.states[i]);
        see_moulton_step(run, known, form, found);
        known.pop_back();
    }
    return found;
}

}  // namespace

Objection adams_moulton_step_objection(const Method& method, int k, const AdamsMoultonForm& form) {
    for (const char* name : {"forced_heavy_top", "forced_free_body", "double_pendulum"})
        for (const std::string& formulation : models::applicable(models::standard(name))) {
            if (!stepping::runs_on(method, models::standard(name), formulation)) continue;
            RecordedRun run(method, {}, models::standard(name), formulation, Real(1) / 64, k + 1);
            const Objection objection = moulton_violations(run, k, form).objection(equations_tolerance());
            if (!objection.empty()) return objection + " on " + name + " as " + formulation;
        }
    return "";
}

KREISEL_STEP_CHECK("multistep/adams_moulton2",
                   [](const Method& method) { return adams_moulton_step_objection(method, 2); });
KREISEL_STEP_CHECK("multistep/adams_moulton3",
                   [](const Method& method) { return adams_moulton_step_objection(method, 3); });
KREISEL_STEP_CHECK("multistep/adams_moulton4",
                   [](const Method& method) { return adams_moulton_step_objection(method, 4); });

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
