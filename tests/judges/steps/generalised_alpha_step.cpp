// SPDX-License-Identifier: BSD-3-Clause
//
// Steps of the generalised-alpha methods, in both forms.
#include "tests/judges/steps/stabilised_step.hpp"
#include "tests/judges/steps/step_checks.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

struct Alphas {
    Real alpha_m, alpha_f, gamma, beta;
};

Alphas alphas_of(const Real& rho) {
    const Real alpha_m = (2 * rho - 1) / (rho + 1), alpha_f = rho / (rho + 1);
    const Real gamma = Real(1) / 2 + alpha_f - alpha_m;
    return {alpha_m, alpha_f, gamma, (gamma + Real(1) / 2) * (gamma + Real(1) / 2) / 4};
}

/// Options, and the parameters that they stand for.
std::vector<std::pair<OptionValues, Alphas>> alpha_cases() {
    std::vector<std::pair<OptionValues, Alphas>> cases;
    for (const double rho : {0.0, 0.5, 0.9}) cases.emplace_back(OptionValues{{"rho", rho}}, alphas_of(decimal(rho)));
    cases.emplace_back(OptionValues{{"alpha_m", -0.25}, {"alpha_f", 0.25}, {"gamma", 0.75}, {"beta", 0.5}},
                       Alphas{Real(-1) / 4, Real(1) / 4, Real(3) / 4, Real(1) / 2});
    return cases;
}

struct Derivatives {
    VecX rate, jerk;
};

/// v' and v'' at the start, the latter the difference of v' over d = h/8 to both sides along the parabola
/// q exp(d v + d^2/2 v'), v + d v'.
Derivatives derivatives_at_start(RecordedRun& run) {
    const RecordedState& start = run.states[0];
    const VecX rate = run.index1_rate(start);
    const auto rate_near = [&](const Real& d) {
        return run.index1_rate({.t = start.t + d,
                                .q = run.bodies.moved(start.q, d * start.v + d * d / 2 * rate),
                                .v = start.v + d * rate,
                                .lambda = {}});
    };
    const Real d = run.h / 8;
    return {rate, (rate_near(d) - rate_near(-d)) / (2 * d)};
}

/// The steps from v, v' and a; `see_end(state)` sees constraints, `rest(i, r)` is what D may not have beside its
/// formula.
template <class SeeEnd, class Rest>
Violations alpha_violations(RecordedRun& run, const Alphas& p, const StabilisedForm& form, VecX v, VecX rate, VecX a,
                            SeeEnd see_end, Rest rest) {
    Violations found;
    for (std::size_t i = 0; i + 1 < run.states.size(); ++i) {
        const RecordedState &now = run.states[i], &next = run.states[i + 1];
        const Real& h = run.h;
        const VecX rate_next = rate_at_end(run, form, next);
        const VecX a_next = ((1 - p.alpha_f) * rate_next + p.alpha_f * rate - p.alpha_m * a) / (1 - p.alpha_m);
        const VecX D = run.bodies.increment(now.q, next.q, form.side) / h;
        found.see("v+ = v + (1 - gamma) h a + gamma h a+", next.v - v - h * ((1 - p.gamma) * a + p.gamma * a_next));
        found.see("D = v + (1/2 - beta) h a + beta h a+ (- M^{-1} C(q)^T eta)",
                  rest(i, D - v - h * ((Real(1) / 2 - p.beta) * a + p.beta * a_next)));
        see_end(next, found);
        rate = rate_next, a = a_next, v = next.v;
    }
    return found;
}

VecX start_of_a(const Alphas& p, const StabilisedForm& form, const Derivatives& start, const Real& h) {
    return form.start_at_rate ? start.rate : VecX(start.rate + (p.alpha_m - p.alpha_f) * h * start.jerk);
}

Violations stabilised_violations(RecordedRun& run, const Alphas& p, const StabilisedForm& form) {
    const Derivatives start = derivatives_at_start(run);
    const auto see_end = [&](const RecordedState& state, Violations& found) {
        see_positions(run, state, found), see_velocities(run, state, found);
    };
    const auto rest = [&](std::size_t i, const VecX& r) { return without_eta_term(run, form, i, r); };
    return alpha_violations(run, p, form, run.states[0].v, start.rate, start_of_a(p, form, start, run.h), see_end,
                            rest);
}

/// Delta, the least velocity with C Delta = C l in the mass metric, l the local error of an increment.
VecX perturbation(RecordedRun& run, const Alphas& p, const StabilisedForm& form, const Derivatives& start) {
    const RecordedState& state = run.states[0];
    const MatX C = run.position_rows(state);
    if (C.rows() == 0) return VecX::Zero(state.v.size());
    const VecX bracket = form.sign_of_bracket * run.bodies.bracket(state.v, start.rate);
    const VecX l = run.h * run.h * ((Real(1) / 6 - p.beta - (p.alpha_m - p.alpha_f) / 2) * start.jerk + bracket / 12);
    MatX directions = C.transpose();
    run.solve_mass(state.q, directions);
    return directions * solved_square(C * directions, C * l);
}

Violations position_violations(RecordedRun& run, const Alphas& p, const StabilisedForm& form, bool perturbed) {
    const Derivatives start = derivatives_at_start(run);
    VecX v = run.states[0].v;
    if (perturbed && !form.unperturbed) v += perturbation(run, p, form, start);
    const auto see_end = [&](const RecordedState& state, Violations& found) { see_positions(run, state, found); };
    const auto rest = [](std::size_t, const VecX& r) { return r; };
    return alpha_violations(run, p, form, v, start.rate, start_of_a(p, form, start, run.h), see_end, rest);
}

}  // namespace

Objection generalised_alpha_step_objection(const Method& method, const StabilisedForm& form) {
    for (const auto& [options, p] : alpha_cases()) {
        const Objection objection = on_models_with_and_without_joints(
            method, options, 3, [&, &p = p](RecordedRun& run) { return stabilised_violations(run, p, form); });
        if (!objection.empty()) return objection + ", alpha_m = " + to_text(p.alpha_m);
    }
    return "";
}

Objection position_alpha_step_objection(const Method& method, const StabilisedForm& form) {
    for (const char* start : {"perturbed", "exact"})
        for (auto [options, p] : alpha_cases()) {
            options["start"] = std::string(start);
            const bool perturbed = std::string(start) == "perturbed";
            const Objection objection = on_models_with_and_without_joints(
                method, options, 3,
                [&, &p = p](RecordedRun& run) { return position_violations(run, p, form, perturbed); });
            if (!objection.empty()) return objection + ", alpha_m = " + to_text(p.alpha_m) + ", start " + start;
        }
    return "";
}

KREISEL_STEP_CHECK("generalized_alpha/index2",
                   [](const Method& method) { return generalised_alpha_step_objection(method); });
KREISEL_STEP_CHECK("generalized_alpha/index3",
                   [](const Method& method) { return position_alpha_step_objection(method); });

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
