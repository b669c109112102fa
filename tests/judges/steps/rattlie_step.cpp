// SPDX-License-Identifier: BSD-3-Clause
//
// RATTLie: residuals of the published equations [hantearnold2021] for the steps of a run, with dense differentials. The
// multipliers at the beginning of a step are not reported, so only the space spanned by their term is checked.
#include <Eigen/LU>

#include "tests/judges/steps/recorded_steps.hpp"
#include "tests/judges/steps/step_checks.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// The local coordinates u of an increment q+ = q tau(u) from its logarithm, and the transposed inverse differentials.
struct DenseIncrements {
    const MatrixGroup group;
    const bool cayley;

    VecX coordinates(const VecX& logarithm) const {
        if (!cayley) return logarithm;
        VecX u = logarithm;
        const Eigen::Index n = group.group->dim();
        for (Eigen::Index i = 0; i < u.size(); i += n) {
            const MatX g = dense_exp(group.hat(VecX(u.segment(i, n)))), I = MatX::Identity(g.rows(), g.cols());
            u.segment(i, n) = group.vee(MatX(2 * (g - I) * MatX(g + I).partialPivLu().inverse()));
        }
        return u;
    }
    /// (d tau^{-1}_{-u})^T, of the left-trivialised inverse at u.
    MatX transposed(const VecX& u) const {
        return block_diagonal(group, u,
                              [&](const VecX& part) {
                                  MatX columns(part.size(), part.size());
                                  for (Eigen::Index k = 0; k < part.size(); ++k) {
                                      const VecX e = VecX::Unit(part.size(), k);
                                      columns.col(k) = cayley ? dense_dcayinv_left(group, part, e)
                                                              : dense_dexpinv_left(group, part, e);
                                  }
                                  return columns;
                              })
            .transpose();
    }
};

VecX force_at_rest(RecordedRun& run, const RecordedState& state) {
    VecX f(state.v.size());
    run.system().applied_force(state.t, state.q.data(), VecX(VecX::Zero(state.v.size())).data(), f.data());
    return f;
}

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

Objection rattlie_step_objection(const Method& method) {
    for (const char* coordinates : {"exp", "cayley"})
        for (const char* name : {"forced_heavy_top", "forced_free_body", "double_pendulum"})
            for (const std::string& formulation : models::applicable(models::standard(name))) {
                const OptionValues options = {{"coordinates", std::string(coordinates)}};
                RecordedRun run(method, options, models::standard(name), formulation, Real(1) / 32, 2);
                const DenseIncrements dense{matrix_group(formulation),
                                            options.at("coordinates") == OptionValue("cayley")};
                const Objection objection = rattlie_violations(run, dense).objection(equations_tolerance());
                if (!objection.empty()) return objection + " on " + name + " as " + formulation + ", " + coordinates;
            }
    return "";
}

KREISEL_STEP_CHECK("variational/rattlie", rattlie_step_objection);

}  // namespace

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
