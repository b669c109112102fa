// SPDX-License-Identifier: BSD-3-Clause
//
// Steps of the half-explicit methods [arnold1998], [arnoldmurua1998], evaluated with dense matrices from the state and
// the multipliers that a step begins with.
#include "tests/judges/steps/half_explicit_step.hpp"

#include "methods/tableaus/bound_tableau.hpp"
#include "tests/judges/steps/recorded_steps.hpp"
#include "tests/judges/steps/step_checks.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

using CoefficientRow = std::vector<Coefficient>;

/// Rows of the stages 2, ..., s + 1, how many of them come before the new state's, and the weights of the multipliers.
struct PublishedRows {
    std::vector<CoefficientRow> a;
    std::size_t result;
    CoefficientRow d;
};

PublishedRows published_herk2() { return {{{1}, {{1, 2}, {1, 2}}}, 1, {{1, 2}, {1, 2}}}; }

PublishedRows published_herk3() { return {{{{1, 2}}, {{2, 9}, {4, 9}}, {{1, 4}, 0, {3, 4}}}, 2, {0, -2, 3}}; }

/// The rows of Dormand and Prince as rkmk/dopri5 has them, and the one that is added.
PublishedRows published_hedop5() {
    PublishedRows rows{method("rkmk/dopri5").factory.scheme->as<MuntheKaasScheme>()->tableau.a, 5,
                       CoefficientRow(7, 0)};
    rows.a.erase(rows.a.begin());
    rows.a.push_back({{-18611506045861, 19738176307200},
                      {59332529, 14479296},
                      {-2509441598627, 893904224850},
                      {2763523204159, 3289696051200},
                      {-41262869588913, 116235927142400},
                      {46310205821, 287848404480},
                      {-3280, 75413}});
    rows.d.back() = 1;
    return rows;
}

struct HalfExplicitStage {
    RecordedState at;
    VecX u, slope, rate;
};

/// The point that a row of coefficients leads to.
HalfExplicitStage stage_of(RecordedRun& run, const RecordedState& start, const CoefficientRow& row,
                           const std::vector<HalfExplicitStage>& stages) {
    HalfExplicitStage made{start, VecX::Zero(start.v.size()), {}, {}};
    for (std::size_t j = 0; j < row.size(); ++j) {
        const Real weight = run.h * value(row[j]);
        made.at.t += weight;
        made.u += weight * stages[j].slope;
        made.at.v += weight * stages[j].rate;
    }
    made.at.q = run.bodies.moved(start.q, made.u);
    return made;
}

/// Lambda with C' (V' + w M^{-1} C^T (0 - Lambda)) + b' = 0, where V' is the next velocity without multipliers.
VecX constraining(RecordedRun& run, const RecordedState& here, const RecordedState& next, const Real& weight) {
    MatX directions = run.position_rows(here).transpose();
    if (directions.cols() == 0) return VecX(0);
    run.solve_mass(here.q, directions);
    return solved_square(weight * run.position_rows(next) * directions, run.velocity_defect(next));
}

/// The state after a step, with its multipliers.
RecordedState half_explicit_result(RecordedRun& run, const PublishedRows& rows, const RecordedState& start,
                                   const HalfExplicitForm& form) {
    std::vector<HalfExplicitStage> stages;
    HalfExplicitStage here = stage_of(run, start, {}, stages);
    RecordedState result;
    VecX lambda = VecX::Zero(start.lambda.size());
    for (std::size_t i = 0; i < rows.a.size(); ++i) {
        here.slope = form.without_dexpinv ? here.at.v : run.bodies.pulled_back(here.u, here.at.v);
        here.at.lambda = start.lambda;
        if (i > 0 || form.first_solved) {
            here.at.lambda.setZero();
            here.rate = run.rate(here.at);
            stages.push_back(here);
            const HalfExplicitStage free = stage_of(run, start, rows.a[i], stages);
            stages.pop_back();
            here.at.lambda = constraining(run, here.at, free.at, run.h * value(rows.a[i].back()));
        }
        here.rate = run.rate(here.at);
        lambda += value(rows.d[i]) * here.at.lambda;
        stages.push_back(here);
        here = stage_of(run, start, rows.a[i], stages);
        if (i == rows.result) result = here.at;
    }
    result.lambda = lambda;
    return result;
}

Violations half_explicit_violations(RecordedRun& run, const PublishedRows& rows, const HalfExplicitForm& form) {
    Violations found;
    RecordedState now = run.states[0];
    now.lambda = run.index1_multipliers(now);
    for (std::size_t i = 1; i < run.states.size(); ++i) {
        const RecordedState &next = run.states[i], expected = half_explicit_result(run, rows, now, form);
        found.see("q+", run.bodies.increment(expected.q, next.q));
        found.see("v+", next.v - expected.v);
        if (expected.lambda.size() > 0) found.see("lambda+", (next.lambda - expected.lambda) / 100);
        found.see("C v + b = 0", run.velocity_defect(next));
        now = next;
        if (now.lambda.size() == 0) now.lambda = expected.lambda;
    }
    return found;
}

Objection half_explicit_objection(const Method& method, const PublishedRows& rows, const HalfExplicitForm& form = {}) {
    return on_models_with_and_without_joints(
        method, {}, 3, [&](RecordedRun& run) { return half_explicit_violations(run, rows, form); });
}

const char* const no_conditions =
    "the conditions of index-2 systems are not in the tests; every coefficient is compared in a step";

}  // namespace

Objection herk3_step_objection(const Method& method, const HalfExplicitForm& form) {
    return half_explicit_objection(method, published_herk3(), form);
}

KREISEL_STEP_CHECK(
    "half_explicit/herk2", [](const Method& method) { return half_explicit_objection(method, published_herk2()); },
    no_conditions);
KREISEL_STEP_CHECK(
    "half_explicit/herk3", [](const Method& method) { return half_explicit_objection(method, published_herk3()); },
    no_conditions);
KREISEL_STEP_CHECK(
    "half_explicit/hedop5", [](const Method& method) { return half_explicit_objection(method, published_hedop5()); },
    no_conditions);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
