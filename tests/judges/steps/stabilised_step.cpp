// SPDX-License-Identifier: BSD-3-Clause
//
// The stabilised index-2 methods: residuals of each published equation for the steps of a run.
// Positions and velocities at the ends of the steps and the reported multipliers are the only data taken from the
// method.
#include "tests/judges/steps/stabilised_step.hpp"

#include "tests/judges/steps/step_checks.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// Steps are long, so that C(q) and C(q+) differ and eta is not small.
Real step_size() { return Real(1) / 32; }

/// judge(run) on one body with and without a constraint and on two with joints, in all their formulations.
template <class F>
Objection on_models(const Method& method, const OptionValues& options, F judge) {
    for (const char* name : {"forced_heavy_top", "forced_free_body", "double_pendulum"})
        for (const std::string& formulation : models::applicable(models::standard(name))) {
            RecordedRun run(method, options, models::standard(name), formulation, step_size(), 3);
            const Objection objection = judge(run).objection(equations_tolerance());
            if (!objection.empty()) return objection + " on " + name + " as " + formulation;
        }
    return "";
}

/// q+, v+, lambda+ satisfy Phi = 0 and C v + b = 0.
void see_constraints(RecordedRun& run, const RecordedState& state, Violations& found) {
    found.see("Phi(q+) = 0", run.position_defect(state));
    found.see("C(q+) v+ + b = 0", run.velocity_defect(state));
}

/// The part of r outside the range of the eta term.
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

struct AlphaParameters {
    explicit AlphaParameters(const Real& rho)
        : alpha_m((2 * rho - 1) / (rho + 1)),
          alpha_f(rho / (rho + 1)),
          gamma(Real(1) / 2 + alpha_f - alpha_m),
          beta((gamma + Real(1) / 2) * (gamma + Real(1) / 2) / 4) {}
    Real alpha_m, alpha_f, gamma, beta;
};

/// a(0) = v' + (alpha_m - alpha_f) h v'', with v'' the difference of v' over d = h/8 to both sides along the parabola
/// q exp(d v + d^2/2 v'), v + d v'.
VecX alpha_start(RecordedRun& run, const AlphaParameters& p) {
    const RecordedState& start = run.states[0];
    const VecX rate = run.index1_rate(start);
    const auto rate_near = [&](const Real& d) {
        return run.index1_rate({.t = start.t + d,
                                .q = run.bodies.moved(start.q, d * start.v + d * d / 2 * rate),
                                .v = start.v + d * rate,
                                .lambda = {}});
    };
    const Real d = run.h / 8;
    return rate + (p.alpha_m - p.alpha_f) * run.h * (rate_near(d) - rate_near(-d)) / (2 * d);
}

Violations generalised_alpha_violations(RecordedRun& run, const AlphaParameters& p, const StabilisedForm& form) {
    Violations found;
    VecX rate = run.index1_rate(run.states[0]);
    VecX a = form.start_at_rate ? rate : alpha_start(run, p);
    for (std::size_t i = 0; i + 1 < run.states.size(); ++i) {
        const RecordedState &now = run.states[i], &next = run.states[i + 1];
        const Real& h = run.h;
        const VecX rate_next = rate_at_end(run, form, next);
        const VecX a_next = ((1 - p.alpha_f) * rate_next + p.alpha_f * rate - p.alpha_m * a) / (1 - p.alpha_m);
        const VecX D = run.bodies.increment(now.q, next.q, form.side) / h;
        found.see("v+ = v + (1 - gamma) h a + gamma h a+", next.v - now.v - h * ((1 - p.gamma) * a + p.gamma * a_next));
        const VecX r = D - now.v - h * ((Real(1) / 2 - p.beta) * a + p.beta * a_next);
        found.see("D = v + (1/2 - beta) h a + beta h a+ - M^{-1} C(q)^T eta", without_eta_term(run, form, i, r));
        see_constraints(run, next, found);
        rate = rate_next, a = a_next;
    }
    return found;
}

/// The state a step earlier: one step of rkmk/rk4 by -h, a method checked against its own scheme.
RecordedState state_before(RecordedRun& run) {
    const RecordedState& start = run.states[0];
    const Method& rk4 = method("rkmk/rk4");
    const auto integrator = rk4.bind(run.system(), stepping::default_options(rk4.description.options));
    VecX y(start.q.size() + start.v.size());
    y << start.q, start.v;
    if (integrator->step(start.t, -run.h, y.data()) != Status::ok) throw std::domain_error("the step back fails");
    return {.t = start.t - run.h, .q = y.head(start.q.size()), .v = y.tail(start.v.size()), .lambda = {}};
}

Violations bliedf2_violations(RecordedRun& run, const StabilisedForm& form) {
    Violations found;
    RecordedState previous = state_before(run);
    VecX D_previous = run.bodies.increment(previous.q, run.states[0].q, form.side) / run.h;
    for (std::size_t i = 0; i + 1 < run.states.size(); ++i) {
        const RecordedState &now = run.states[i], &next = run.states[i + 1];
        const VecX D = run.bodies.increment(now.q, next.q, form.side) / run.h;
        found.see("h v'+ = 3/2 v+ - 2 v + 1/2 v_previous",
                  run.h * rate_at_end(run, form, next) - (3 * next.v - 4 * now.v + previous.v) / 2);
        const VecX r = next.v - (3 * D - form.sign_of_previous * D_previous) / 2;
        found.see("v+ = 3/2 (D + M^{-1} C(q)^T eta) - 1/2 D_previous", without_eta_term(run, form, i, r));
        see_constraints(run, next, found);
        previous = now, D_previous = D;
    }
    return found;
}

}  // namespace

Objection generalised_alpha_step_objection(const Method& method, const StabilisedForm& form) {
    for (const double rho : {0.0, 0.5, 0.9}) {
        const AlphaParameters p(decimal(rho));
        const Objection objection = on_models(
            method, {{"rho", rho}}, [&](RecordedRun& run) { return generalised_alpha_violations(run, p, form); });
        if (!objection.empty()) return objection + ", rho = " + to_text(decimal(rho));
    }
    return "";
}

Objection bliedf2_step_objection(const Method& method, const StabilisedForm& form) {
    return on_models(method, {}, [&](RecordedRun& run) { return bliedf2_violations(run, form); });
}

KREISEL_STEP_CHECK("generalized_alpha/index2",
                   [](const Method& method) { return generalised_alpha_step_objection(method); });
KREISEL_STEP_CHECK("multistep/bliedf2", [](const Method& method) { return bliedf2_step_objection(method); });

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
