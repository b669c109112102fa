// SPDX-License-Identifier: BSD-3-Clause
//
// Steps of the BLieDF methods in the stabilised index-2 form and the index-3 form.
#include <array>

#include "tests/judges/steps/stabilised_step.hpp"
#include "tests/judges/steps/step_checks.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// alpha of the backward differentiation formula over k steps, from those of fewer: sum_j 1/j nabla^j.
std::vector<Real> differentiation(int k) {
    std::vector<Real> alpha(4, 0);
    const std::array<std::array<int, 4>, 3> nabla = {{{1, -1, 0, 0}, {1, -2, 1, 0}, {1, -3, 3, -1}}};
    for (int j = 1; j <= k; ++j)
        for (std::size_t i = 0; i < 4; ++i) alpha[i] += Real(nabla[static_cast<std::size_t>(j - 1)][i]) / j;
    return alpha;
}

/// States and Delta = D - h^2/12 [v, v'], the latest last; Delta i leads from state i to the next.
struct Past {
    std::vector<RecordedState> states;
    std::vector<VecX> deltas;
};

Past past_of_start(RecordedRun& run, std::size_t k, const VecX& correction, const StabilisedForm& form) {
    Past past;
    past.states = {run.states[0]};
    while (past.states.size() < k) past.states.insert(past.states.begin(), state_before(run, past.states[0]));
    for (std::size_t i = 0; i + 1 < k; ++i)
        past.deltas.push_back(run.bodies.increment(past.states[i].q, past.states[i + 1].q, form.side) / run.h -
                              correction);
    return past;
}

Violations bliedf_violations(RecordedRun& run, int order, const StabilisedForm& form) {
    const auto k = static_cast<std::size_t>(order);
    const std::vector<Real> alpha = differentiation(order);
    const Real& h = run.h;
    const auto correction = [&](const VecX& v, const VecX& rate) -> VecX {
        return k < 3 ? VecX::Zero(v.size()) : VecX(form.sign_of_bracket * h * h / 12 * run.bodies.bracket(v, rate));
    };
    Violations found;
    VecX rate = run.index1_rate(run.states[0]);
    Past past = past_of_start(run, k, correction(run.states[0].v, rate), form);
    for (std::size_t i = 0; i + 1 < run.states.size(); ++i) {
        const RecordedState &now = run.states[i], &next = run.states[i + 1];
        past.deltas.push_back(run.bodies.increment(now.q, next.q, form.side) / h - correction(now.v, rate));
        past.states.push_back(next);
        rate = rate_at_end(run, form, next);
        VecX differences = h * rate, r = next.v;
        Real gamma = 0;
        for (std::size_t j = 0; j <= k; ++j) differences -= alpha[j] * past.states[past.states.size() - 1 - j].v;
        for (std::size_t j = 0; j < k; ++j) {
            gamma += alpha[j];
            r -= gamma * (j > 0 ? form.sign_of_previous : 1) * past.deltas[past.deltas.size() - 1 - j];
        }
        found.see("h v'+ = sum_j alpha_j v_{n+1-j}", differences);
        found.see("v+ = sum_j gamma_j Delta_{n-j}, D = Delta + ... - M^{-1} C(q)^T eta",
                  without_eta_term(run, form, i, r));
        see_positions(run, next, found);
        if (!form.positions_alone) see_velocities(run, next, found);
    }
    return found;
}

constexpr StabilisedForm index3_form = {.without_eta = true, .positions_alone = true};

}  // namespace

Objection bliedf_step_objection(const Method& method, int k, const StabilisedForm& form) {
    return on_models_with_and_without_joints(method, {}, 4,
                                             [&](RecordedRun& run) { return bliedf_violations(run, k, form); });
}

KREISEL_STEP_CHECK("multistep/bliedf1", [](const Method& method) { return bliedf_step_objection(method, 1); });
KREISEL_STEP_CHECK("multistep/bliedf2", [](const Method& method) { return bliedf_step_objection(method, 2); });
KREISEL_STEP_CHECK("multistep/bliedf3", [](const Method& method) { return bliedf_step_objection(method, 3); });
KREISEL_STEP_CHECK("multistep/bliedf1_index3",
                   [](const Method& method) { return bliedf_step_objection(method, 1, index3_form); });
KREISEL_STEP_CHECK("multistep/bliedf2_index3",
                   [](const Method& method) { return bliedf_step_objection(method, 2, index3_form); });
KREISEL_STEP_CHECK("multistep/bliedf3_index3",
                   [](const Method& method) { return bliedf_step_objection(method, 3, index3_form); });

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
