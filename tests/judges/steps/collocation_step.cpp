// SPDX-License-Identifier: BSD-3-Clause
//
// A step of the lifted Gauss, Radau IIA and Lobatto IIIA-IIIB methods [hairer1996], [hairer2006], [zanna2001]: nodes
// are zeros of combinations of Legendre polynomials, a_ij the integrals of Lagrange's, by Vandermonde's equations
//   sum_j a_ij c_j^k = c_i^(k+1)/(k + 1),   and of IIIB   sum_i b_i c_i^k a^_ij = b_j (1 - c_j^(k+1))/(k + 1).
// The stages are iterated with dense matrices until they stand.
#include "tests/judges/steps/collocation_step.hpp"

#include "tests/judges/steps/step_checks.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

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

Violations collocation_violations(RecordedRun& run, const CollocationForm& form) {
    const RecordedState &before = run.states[0], &after = run.states[1];
    DenseCollocation stages(run, form);
    stages.sweep(before, KREISEL_QUAD ? 60 : 30);
    Violations found;
    found.see("y+ = y exp(h sum_i b_i k_i)", DenseStates(run).increment(before, after) - stages.increment());
    return found;
}

}  // namespace

DenseCollocation::DenseCollocation(RecordedRun& run, const CollocationForm& form)
    : states_(run), h_(run.h), rows_(collocation_rows(form)), around_middle_(form.around_middle) {}

void DenseCollocation::sweep(const RecordedState& start, int times) {
    if (slopes_.size() == 0) slopes_ = states_.slope(start).replicate(1, rows_.c.size());
    const Eigen::Index n = states_.dim() / 2;
    for (int sweep = 0; sweep < times; ++sweep) {
        const MatX old = slopes_;
        const VecX centre = around_middle_ ? VecX(h_ / 2 * old * rows_.b) : VecX::Zero(states_.dim());
        const RecordedState middle = states_.moved(start, centre, start.t);
        for (Eigen::Index i = 0; i < rows_.c.size(); ++i) {
            VecX u(states_.dim());
            u << old.topRows(n) * rows_.a.row(i).transpose(), old.bottomRows(n) * rows_.a_hat.row(i).transpose();
            u = h_ * u - centre;
            const RecordedState at = states_.moved(middle, u, start.t + rows_.c[i] * h_);
            slopes_.col(i) = states_.pulled_back(u, states_.slope(at));
        }
    }
}

VecX DenseCollocation::increment() const { return h_ * slopes_ * rows_.b; }

Objection collocation_step_objection(const Method& method, const CollocationForm& form) {
    return on_models_with_and_without_joints(method, {}, 1,
                                             [&](RecordedRun& run) { return collocation_violations(run, form); });
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
