// SPDX-License-Identifier: BSD-3-Clause
//
// Munthe-Kaas methods with few commutators, methods/rkmk/few_commutators.hpp. One step is evaluated as printed, in
// right trivialisation: if q' = q k, then Y = q^{-1} moves by Y' = -k Y, and q is its inverse.
#include <Eigen/LU>
#include <algorithm>

#include "tests/judges/conditions/bracket_series.hpp"
#include "tests/judges/families/scheme_family.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// Matrix of u for the slopes k = -h v of Y.
MatX printed_sum(const BracketSum& sum, const std::vector<MatX>& k, const MatX& zero) {
    MatX u = zero;
    for (std::size_t j = 0; j < sum.weights.size(); ++j) u += value(sum.weights[j]) * k.at(j);
    for (const BracketTerm& term : sum.brackets) {
        const MatX &a = k.at(static_cast<std::size_t>(term.left - 1)),
                   &b = k.at(static_cast<std::size_t>(term.right - 1));
        u += value(term.coefficient) * (MatX(a * b) - MatX(b * a));
    }
    return u;
}

DenseStep few_commutators_step(const FewCommutatorsScheme& scheme, const ScriptedStep& given) {
    const MatX start = given.start.q.partialPivLu().inverse();
    std::vector<MatX> k;
    const auto point = [&](const BracketSum& sum) -> DensePoint {
        const MatX Y = dense_exp(printed_sum(sum, k, MatX::Zero(start.rows(), start.cols()))) * start;
        Real c = 0;
        for (const Coefficient& weight : sum.weights) c += value(weight);
        return {given.start.t + c * given.h, Y.partialPivLu().inverse(),
                given.start.v + given.h * combination(sum.weights, given.script, given.start.v.size())};
    };
    DenseStep step;
    for (const BracketSum& stage : scheme.stages) {
        step.stages.push_back(point(stage));
        k.push_back(-given.h * given.group.hat(step.stages.back().v));
    }
    step.result = point(scheme.result);
    return step;
}

/// In left trivialisation brackets change their sign, which is what the words of the conditions are for.
orders::BracketRow<orders::Rational> left_row(const BracketSum& sum) {
    orders::BracketRow<orders::Rational> row;
    for (const Coefficient& weight : sum.weights) row.weights.push_back(orders::exact(weight));
    for (const BracketTerm& term : sum.brackets)
        row.brackets.push_back({static_cast<std::size_t>(term.left - 1), static_cast<std::size_t>(term.right - 1),
                                -orders::exact(term.coefficient)});
    return row;
}

bool has_digits(const BracketSum& sum) {
    return std::any_of(sum.weights.begin(), sum.weights.end(), [](const Coefficient& w) { return w.digits; }) ||
           std::any_of(sum.brackets.begin(), sum.brackets.end(),
                       [](const BracketTerm& t) { return t.coefficient.digits; });
}

SchemeOrders few_commutators_orders(const FewCommutatorsScheme& scheme) {
    orders::BracketMethod<orders::Rational> method;
    for (const BracketSum& stage : scheme.stages) method.stages.push_back(left_row(stage));
    method.result = left_row(scheme.result);
    const bool digits =
        has_digits(scheme.result) || std::any_of(scheme.stages.begin(), scheme.stages.end(), has_digits);
    return {.step = orders::bracket_order(method, orders::rounding(digits))};
}

ClassicalScheme few_commutators_classical(const FewCommutatorsScheme& scheme) {
    Tableau linear;
    for (const BracketSum& stage : scheme.stages) linear.a.push_back(stage.weights);
    linear.b = scheme.result.weights;
    return classical_scheme(linear);
}

}  // namespace

KREISEL_SCHEME_FAMILY("Munthe-Kaas with few commutators", few_commutators_step, few_commutators_orders,
                      few_commutators_classical);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
