// SPDX-License-Identifier: BSD-3-Clause
//
// A step of the lifted Gauss methods [hairer2006], [zanna2001]: nodes are the zeros of Legendre polynomials, and a_ij
// the integrals of Lagrange's, by Vandermonde's equations sum_j a_ij c_j^k = c_i^(k+1)/(k + 1). The stages are iterated
// with dense matrices until they stand.
#include "tests/judges/steps/gauss_step.hpp"

#include "tests/judges/steps/recorded_steps.hpp"
#include "tests/judges/steps/step_checks.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

struct GaussRows {
    VecX c, b;
    MatX a;  ///< row i: a_i1, a_i2, ...
};

GaussRows gauss_rows(int stages) {
    GaussRows rows{VecX::Constant(stages, Real(1) / 2), VecX(stages), MatX(stages, stages)};
    const Real away = sqrt(stages == 2 ? Real(1) / 3 : Real(3) / 5) / 2;
    rows.c[0] -= away, rows.c[stages - 1] += away;
    MatX powers = MatX::Ones(stages, stages), integrals(stages, stages);  // row k: c^k, c^(k + 1) / (k + 1)
    VecX whole(stages);
    for (int k = 0; k < stages; ++k) {
        if (k > 0) powers.row(k) = powers.row(k - 1).cwiseProduct(rows.c.transpose());
        integrals.row(k) = powers.row(k).cwiseProduct(rows.c.transpose()) / (k + 1);
        whole[k] = Real(1) / (k + 1);
    }
    for (int i = 0; i < stages; ++i) rows.a.row(i) = solved_square(powers, integrals.col(i)).transpose();
    rows.b = solved_square(powers, whole);
    return rows;
}

/// k_i and v'_i as columns.
struct GaussSlopes {
    MatX k, rate;
};

GaussSlopes iterated(RecordedRun& run, const RecordedState& start, const GaussRows& rows, const GaussSlopes& old,
                     bool around_start) {
    GaussSlopes next = old;
    const VecX centre = around_start ? VecX::Zero(start.v.size()) : VecX(run.h / 2 * old.k * rows.b);
    for (Eigen::Index i = 0; i < rows.c.size(); ++i) {
        const VecX u = run.h * old.k * rows.a.row(i).transpose() - centre;
        const RecordedState at = {.t = start.t + rows.c[i] * run.h,
                                  .q = run.bodies.moved(run.bodies.moved(start.q, centre), u),
                                  .v = start.v + run.h * old.rate * rows.a.row(i).transpose(),
                                  .lambda = {}};
        next.k.col(i) = run.bodies.pulled_back(u, at.v);
        next.rate.col(i) = run.index1_rate(at);
    }
    return next;
}

Violations gauss_violations(RecordedRun& run, const GaussRows& rows, bool around_start) {
    const RecordedState &before = run.states[0], &after = run.states[1];
    const Eigen::Index stages = rows.c.size();
    GaussSlopes slopes{before.v.replicate(1, stages), run.index1_rate(before).replicate(1, stages)};
    for (int i = 0; i < (KREISEL_QUAD ? 60 : 30); ++i) slopes = iterated(run, before, rows, slopes, around_start);
    Violations found;
    found.see("q+ = q exp(theta)", run.bodies.increment(before.q, after.q) - run.h * slopes.k * rows.b);
    found.see("v+ = v + h sum_i b_i f_i", after.v - before.v - run.h * slopes.rate * rows.b);
    return found;
}

}  // namespace

Objection gauss_step_objection(const Method& method, int stages, bool around_start) {
    const GaussRows rows = gauss_rows(stages);
    return on_models_with_and_without_joints(
        method, {}, 1, [&](RecordedRun& run) { return gauss_violations(run, rows, around_start); });
}

KREISEL_STEP_CHECK("rkmk/gauss2", [](const Method& method) { return gauss_step_objection(method, 2); });
KREISEL_STEP_CHECK("rkmk/gauss3", [](const Method& method) { return gauss_step_objection(method, 3); });

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
