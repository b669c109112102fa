// SPDX-License-Identifier: BSD-3-Clause
//
// Lie-Verlet and Lie-Newmark: residuals of the published equations for the steps of a run, dense: the discrete
// Moser-Veselov algorithm in matrices [leeleokmcclamroch2007], momenta by dense differentials [bourabeemarsden2009].
#include "tests/judges/steps/dense_increments.hpp"
#include "tests/judges/steps/step_checks.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

const std::vector<const char*>& unconstrained_models() {
    static const std::vector<const char*> all = {"forced_heavy_top", "asymmetric_heavy_top", "forced_free_body",
                                                 "free_top"};
    return all;
}

/// p = M v + h/2 f(t, q), and what is left of M v+ - h/2 f(t+, q+).
struct Kicked {
    VecX before, after;
};
Kicked kicked(RecordedRun& run) {
    const RecordedState &now = run.states[0], &next = run.states[1];
    const MatX M = run.mass(now.q);
    return {M * now.v + run.h / 2 * force_at_rest(run, now), M * next.v - run.h / 2 * force_at_rest(run, next)};
}

/// In the coordinates of increments, as for RATTLie.
Violations lie_verlet_violations(RecordedRun& run, const DenseIncrements& dense) {
    const RecordedState &now = run.states[0], &next = run.states[1];
    const VecX u = dense.coordinates(run.bodies.increment(now.q, next.q)), p = run.mass(now.q) * u / run.h;
    const Kicked k = kicked(run);
    Violations found;
    found.see("p after the first kick", dense.transposed(-u) * p - k.before);
    found.see("p before the second", dense.transposed(u) * p - k.after);
    return found;
}

/// h p^ = F J_d - J_d F^T, p+ = F^T p with F = R^T R+ and J_d = tr(J)/2 - J; translations keep their momentum.
Violations moser_veselov_violations(RecordedRun& run) {
    const RecordedState &now = run.states[0], &next = run.states[1];
    const MatX M = run.mass(now.q);
    const VecX w = run.bodies.increment(now.q, next.q);
    const Kicked k = kicked(run);
    const Eigen::Index at = w.size() - 3;  // one body, its rotation last
    const MatX J = M.bottomRightCorner(3, 3), Jd = J.trace() / 2 * MatX::Identity(3, 3) - J;
    const MatX F = dense_exp(hat(Vec3(w.tail(3)))), S = F * Jd - Jd * F.transpose();
    const Vec3 momentum(S(2, 1), S(0, 2), S(1, 0));
    Violations found;
    found.see("F J_d - J_d F^T", momentum / run.h - k.before.tail(3));
    found.see("p+ = F^T p", F.transpose() * k.before.tail(3) - k.after.tail(3));
    found.see("x+ = x + h p/m", VecX((M * w / run.h - k.before).head(at)));
    found.see("linear momentum", VecX((k.after - k.before).head(at)));
    return found;
}

Objection lie_verlet_objection(const Method& method) {
    const Objection objection = on_increments(method, 1, lie_verlet_violations);
    if (!objection.empty()) return objection;
    for (const char* name : unconstrained_models())
        for (const std::string& formulation : models::applicable(models::standard(name))) {
            if (!stepping::runs_on(method, models::standard(name), formulation)) continue;
            RecordedRun run(method, {{"coordinates", std::string("matrix")}}, models::standard(name), formulation,
                            Real(1) / 64, 1);
            const Objection found = moser_veselov_violations(run).objection(equations_tolerance());
            if (!found.empty()) return found + " on " + name + " as " + formulation;
        }
    return "";
}

/// V = v + h/2 a, q+ = q tau(h V), v+ = V + h/2 a+.
Violations lie_newmark_violations(RecordedRun& run, const DenseIncrements& dense) {
    const RecordedState &now = run.states[0], &next = run.states[1];
    const Real& h = run.h;
    const VecX V = now.v + h / 2 * run.index1_rate(now);
    Violations found;
    found.see("q+ = q tau(h V)", dense.coordinates(run.bodies.increment(now.q, next.q)) / h - V);
    found.see("v+ = V + h/2 a+", V + h / 2 * run.index1_rate(next) - next.v);
    return found;
}

KREISEL_STEP_CHECK("variational/lie_verlet", lie_verlet_objection);
KREISEL_STEP_CHECK("variational/lie_newmark",
                   [](const Method& method) { return on_increments(method, 1, lie_newmark_violations); });

}  // namespace

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
