// SPDX-License-Identifier: BSD-3-Clause
//
// Methods that carry momenta by the coadjoint action, in dense matrices: Ad of exp(u) is the exponential of ad_u.
#include "tests/judges/steps/recorded_steps.hpp"
#include "tests/judges/steps/step_checks.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

MatX coadjoint(const MatrixGroup& group, const VecX& u) {
    return block_diagonal(group, u, [&](const VecX& part) { return dense_exp(dense_ad(group, part)); }).transpose();
}

VecX force_at(RecordedRun& run, const Real& t, const VecX& q, const VecX& v) {
    VecX f(v.size());
    run.system().applied_force(t, q.data(), v.data(), f.data());
    return f;
}

/// One step of every model that the method takes; judge(run, group of a body).
template <class F>
Objection on_each_model(const Method& method, F judge) {
    for (const models::Named& named : models::for_methods())
        for (const std::string& formulation : models::applicable(named.model)) {
            if (!stepping::runs_on(method, named.model, formulation)) continue;
            RecordedRun run(method, {}, named.model, formulation, Real(1) / 512, 1);
            const Violations found = judge(run, matrix_group(formulation));
            const Objection objection =
                found.objection(2000 * epsilon * max(Real(1), run.states[0].v.cwiseAbs().maxCoeff()));
            if (!objection.empty()) return objection + " on " + named.name + " as " + formulation;
        }
    return "";
}

/// u = h V, M v+ = Ad*_{exp u} M v + h Ad*_{exp(u/2)} f with V = (v + v+)/2 [simowong1991]; `gradient`: with the
/// discrete gradient of [gonzalez1996].
Violations energy_momentum_violations(RecordedRun& run, const MatrixGroup& group, bool gradient) {
    const RecordedState &before = run.states[0], &after = run.states[1];
    System& system = run.system();
    const Real& h = run.h;
    const VecX V = (before.v + after.v) / 2, u = h * V;
    const MatX M = run.mass(before.q);
    VecX f = force_at(run, before.t + h / 2, run.bodies.moved(before.q, u / 2), V);
    if (gradient && system.has_potential()) {
        const Real gained = system.potential(after.t, after.q.data()) - system.potential(before.t, before.q.data());
        f -= (gained + u.dot(f)) / u.dot(M * u) * (M * u);
    }
    MatX excess = M * after.v - coadjoint(group, u) * (M * before.v) - h * coadjoint(group, u / 2) * f;
    run.solve_mass(before.q, excess);
    Violations found;
    found.see("q+ = q exp(h V)", run.bodies.increment(before.q, after.q) - u);
    found.see("p+ = Ad* (Ad* p + h f)", excess.col(0));
    return found;
}

/// Half an impulse, two free motions, half an impulse [krysl2005]; the increments by iterating their equation.
Violations liemid_violations(RecordedRun& run, const MatrixGroup& group) {
    const RecordedState &before = run.states[0], &after = run.states[1];
    const Real& h = run.h;
    const VecX rest = VecX::Zero(before.v.size());
    VecX q = before.q, p = run.mass(q) * before.v + h / 2 * force_at(run, before.t, q, rest);
    for (int half = 0; half < 2; ++half) {
        VecX u = rest;
        for (int i = 0; i < (KREISEL_QUAD ? 40 : 20); ++i) {
            MatX rate = coadjoint(group, u / 2) * p;
            run.solve_mass(q, rate);
            u = h / 2 * rate.col(0);
        }
        p = coadjoint(group, u) * p;
        q = run.bodies.moved(q, u);
    }
    MatX excess = p + h / 2 * force_at(run, after.t, after.q, rest) - run.mass(q) * after.v;
    run.solve_mass(q, excess);
    Violations found;
    found.see("q+", run.bodies.increment(q, after.q));
    found.see("p+", excess.col(0));
    return found;
}

KREISEL_STEP_CHECK("energy/simo_wong", [](const Method& method) {
    return on_each_model(method, [](RecordedRun& run, const MatrixGroup& group) {
        return energy_momentum_violations(run, group, false);
    });
});
KREISEL_STEP_CHECK("energy/discrete_gradient", [](const Method& method) {
    return on_each_model(method, [](RecordedRun& run, const MatrixGroup& group) {
        return energy_momentum_violations(run, group, true);
    });
});
KREISEL_STEP_CHECK("energy/liemid_ea", [](const Method& method) { return on_each_model(method, liemid_violations); });

}  // namespace

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
