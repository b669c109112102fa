// SPDX-License-Identifier: BSD-3-Clause
//
// A step of the lifted Gauss, Radau IIA and Lobatto IIIA-IIIB methods [hairer1996], [hairer2006], [zanna2001]: nodes
// are zeros of combinations of Legendre polynomials, a_ij the integrals of Lagrange's, by Vandermonde's equations
//   sum_j a_ij c_j^k = c_i^(k+1)/(k + 1),   and of IIIB   sum_i b_i c_i^k a^_ij = b_j (1 - c_j^(k+1))/(k + 1).
// The stages are iterated with dense matrices until they stand.
#include "tests/judges/steps/collocation_step.hpp"

#include "tests/judges/steps/recorded_steps.hpp"
#include "tests/judges/steps/step_checks.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

struct CollocationRows {
    VecX c, b;
    MatX a, a_hat;  ///< row i: a_i1, a_i2, ...; a_hat: of velocities
};

/// Symmetric about 1/2, the inner ones `away` from it.
VecX symmetric_nodes(int stages, const Real& away, bool with_ends) {
    VecX c = VecX::Constant(stages, Real(1) / 2);
    const int first = with_ends ? 1 : 0;
    c[first] -= away, c[stages - 1 - first] += away;
    if (with_ends) c[0] = 0, c[stages - 1] = 1;
    return c;
}

/// Zeros of P_s, of P_s - P_{s-1}, and of c (c - 1) P'_{s-1} on [0, 1].
VecX nodes_of(const CollocationForm& form) {
    const int s = form.stages;
    if (form.points == CollocationPoints::gauss)
        return symmetric_nodes(s, sqrt(s == 2 ? Real(1) / 3 : Real(3) / 5) / 2, false);
    if (form.points == CollocationPoints::lobatto)
        return symmetric_nodes(s, s == 4 ? Real(sqrt(Real(1) / 5) / 2) : Real(0), true);
    VecX c = VecX::Ones(s);  // with those of 3 c - 1 or 10 c^2 - 8 c + 1
    if (s == 2)
        c[0] = Real(1) / 3;
    else
        c[0] = (4 - sqrt(Real(6))) / 10, c[1] = (4 + sqrt(Real(6))) / 10;
    return c;
}

CollocationRows collocation_rows(const CollocationForm& form) {
    const int stages = form.stages;
    CollocationRows rows{nodes_of(form), VecX(stages), MatX(stages, stages), MatX(stages, stages)};
    MatX powers = MatX::Ones(stages, stages), integrals(stages, stages);  // row k: c^k, c^(k + 1) / (k + 1)
    VecX whole(stages);
    for (int k = 0; k < stages; ++k) {
        if (k > 0) powers.row(k) = powers.row(k - 1).cwiseProduct(rows.c.transpose());
        integrals.row(k) = powers.row(k).cwiseProduct(rows.c.transpose()) / (k + 1);
        whole[k] = Real(1) / (k + 1);
    }
    for (int i = 0; i < stages; ++i) rows.a.row(i) = solved_square(powers, integrals.col(i)).transpose();
    rows.b = solved_square(powers, whole);
    rows.a_hat = rows.a;
    if (!form.velocities_by_companion) return rows;
    const MatX weighted = powers * rows.b.asDiagonal();
    for (int j = 0; j < stages; ++j)
        rows.a_hat.col(j) = solved_square(weighted, VecX(rows.b[j] * (whole - integrals.col(j))));
    return rows;
}

/// k_i and v'_i as columns.
struct CollocationSlopes {
    MatX k, rate;
};

CollocationSlopes iterated(RecordedRun& run, const RecordedState& start, const CollocationRows& rows,
                           const CollocationSlopes& old, bool around_middle) {
    CollocationSlopes next = old;
    const VecX centre = around_middle ? VecX(run.h / 2 * old.k * rows.b) : VecX::Zero(start.v.size());
    for (Eigen::Index i = 0; i < rows.c.size(); ++i) {
        const VecX u = run.h * old.k * rows.a.row(i).transpose() - centre;
        const RecordedState at = {.t = start.t + rows.c[i] * run.h,
                                  .q = run.bodies.moved(run.bodies.moved(start.q, centre), u),
                                  .v = start.v + run.h * old.rate * rows.a_hat.row(i).transpose(),
                                  .lambda = {}};
        next.k.col(i) = run.bodies.pulled_back(u, at.v);
        next.rate.col(i) = run.index1_rate(at);
    }
    return next;
}

Violations collocation_violations(RecordedRun& run, const CollocationRows& rows, bool around_middle) {
    const RecordedState &before = run.states[0], &after = run.states[1];
    const Eigen::Index stages = rows.c.size();
    CollocationSlopes slopes{before.v.replicate(1, stages), run.index1_rate(before).replicate(1, stages)};
    for (int i = 0; i < (KREISEL_QUAD ? 60 : 30); ++i) slopes = iterated(run, before, rows, slopes, around_middle);
    Violations found;
    found.see("q+ = q exp(theta)", run.bodies.increment(before.q, after.q) - run.h * slopes.k * rows.b);
    found.see("v+ = v + h sum_i b_i f_i", after.v - before.v - run.h * slopes.rate * rows.b);
    return found;
}

}  // namespace

Objection collocation_step_objection(const Method& method, const CollocationForm& form) {
    const CollocationRows rows = collocation_rows(form);
    return on_models_with_and_without_joints(
        method, {}, 1, [&](RecordedRun& run) { return collocation_violations(run, rows, form.around_middle); });
}

KREISEL_STEP_CHECK("rkmk/gauss2",
                   [](const Method& method) { return collocation_step_objection(method, gauss_form(2)); });
KREISEL_STEP_CHECK("rkmk/gauss3",
                   [](const Method& method) { return collocation_step_objection(method, gauss_form(3)); });
KREISEL_STEP_CHECK("rkmk/radau2a2",
                   [](const Method& method) { return collocation_step_objection(method, radau_form(2)); });
KREISEL_STEP_CHECK("rkmk/radau2a3",
                   [](const Method& method) { return collocation_step_objection(method, radau_form(3)); });
KREISEL_STEP_CHECK("rkmk/lobatto3ab2",
                   [](const Method& method) { return collocation_step_objection(method, lobatto_form(2)); });
KREISEL_STEP_CHECK("rkmk/lobatto3ab3",
                   [](const Method& method) { return collocation_step_objection(method, lobatto_form(3)); });
KREISEL_STEP_CHECK("rkmk/lobatto3ab4",
                   [](const Method& method) { return collocation_step_objection(method, lobatto_form(4)); });

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
