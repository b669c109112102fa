// SPDX-License-Identifier: BSD-3-Clause
//
// Extrapolation of the midpoint rule on the group, methods/extrapolation/base.hpp: rows multiplied out as matrices, and
// Lagrange's polynomial in h^2 through the logarithms of a^{-1} y, a the result of the first row.
//
// The result is not a product of exponentials of slopes, but its series in words of elementary differentials can be
// generated all the same, logarithms included. Up to order 6 the order on the group is that of these series; what is
// beyond is left to R^n, where the rule is Gragg's.
#include <Eigen/LU>

#include "methods/conditions/tableau_orders.hpp"
#include "methods/extrapolation/gragg_tableau.hpp"
#include "tests/judges/conditions/bracket_series.hpp"
#include "tests/judges/families/scheme_family.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

using orders::OrderedForests;
using orders::Rational;
using RationalSeries = orders::Series<Rational>;

/// What the result with 2j substeps counts in the extrapolation of those with 2 first, ..., 2 columns of them.
template <class T>
std::vector<T> lagrange_weights(int first, int columns) {
    std::vector<T> weights;
    for (int j = 1; j <= columns; ++j) {
        T w = j < first ? 0 : 1;
        for (int i = first; i <= columns; ++i)
            if (i != j) w *= T(j * j) / T(j * j - i * i);
        weights.push_back(w);
    }
    return weights;
}

/// The state h further along a slope.
DensePoint moved(const MatrixGroup& group, const DensePoint& from, const Real& h, const VecX& v, const VecX& rate) {
    return {from.t + h, MatX(from.q * dense_exp(group.hat(h * v))), from.v + h * rate};
}

/// The results of the rows; their points join `stages`.
std::vector<DensePoint> dense_rows(int columns, const ScriptedStep& given, std::vector<DensePoint>& stages) {
    std::vector<DensePoint> rows;
    stages = {given.start};
    for (int j = 1; j <= columns; ++j) {
        const Real h = given.h / (2 * j);
        DensePoint before = given.start, now = moved(given.group, before, h, before.v, given.script.at(0));
        for (int i = 1; i < 2 * j; ++i) {
            stages.push_back(now);
            const DensePoint next = moved(given.group, before, 2 * h, now.v, given.script.at(stages.size() - 1));
            before = now, now = next;
        }
        rows.push_back(now);
    }
    return rows;
}

DenseStep group_extrapolation_step(const GroupExtrapolationScheme& scheme, const ScriptedStep& given) {
    DenseStep step;
    const auto rows = dense_rows(scheme.columns, given, step.stages);
    const auto extrapolated = [&](const std::vector<Real>& weights) -> VecX {
        const Eigen::Index n = given.start.v.size();
        VecX u = VecX::Zero(2 * n);
        for (std::size_t j = 0; j < rows.size(); ++j) {
            const MatX from_first = rows[0].q.partialPivLu().solve(rows[j].q);
            u.head(n) += weights[j] * given.group.vee(dense_log(from_first));
            u.tail(n) += weights[j] * rows[j].v;
        }
        return u;
    };
    const VecX u = extrapolated(lagrange_weights<Real>(1, scheme.columns));
    const Eigen::Index n = given.start.v.size();
    step.result = {given.start.t + given.h, MatX(rows[0].q * dense_exp(given.group.hat(u.head(n)))), u.tail(n)};
    step.error = u - extrapolated(lagrange_weights<Real>(2, scheme.columns));
    return step;
}

/// sum_{m > 0} c_m x^m.
template <class Coefficients>
RationalSeries power_sum(const OrderedForests& forests, const RationalSeries& x, Coefficients c) {
    RationalSeries power = orders::one<Rational>(forests), sum(forests.size(), Rational(0));
    int longest = 0;
    for (std::size_t w = 0; w < forests.size(); ++w) longest = std::max(longest, forests.nodes(w));
    for (int m = 1; m <= longest; ++m) {
        power = orders::concatenation(forests, power, x);
        for (std::size_t w = 0; w < sum.size(); ++w) sum[w] += c(m) * power[w];
    }
    return sum;
}

/// y^{-1} and log y of a series with constant term 1.
RationalSeries inverse_of(const OrderedForests& forests, RationalSeries y) {
    y[0] = 0;
    RationalSeries inverse = power_sum(forests, y, [](int m) { return Rational(m % 2 == 0 ? 1 : -1); });
    inverse[0] = 1;
    return inverse;
}
RationalSeries logarithm_of(const OrderedForests& forests, RationalSeries y) {
    y[0] = 0;
    return power_sum(forests, y, [](int m) { return Rational(m % 2 == 0 ? -1 : 1, m); });
}

/// The result of a row, h = 1.
RationalSeries row_series(const OrderedForests& forests, int substeps) {
    const Rational h(1, substeps);
    RationalSeries before = orders::one<Rational>(forests);
    RationalSeries now = orders::append_exponential(forests, before, h, before);
    for (int i = 1; i < substeps; ++i) {
        const RationalSeries next = orders::append_exponential(forests, before, Rational(2 * h), now);
        before = now, now = next;
    }
    return now;
}

RationalSeries extrapolated_series(const OrderedForests& forests, const std::vector<Rational>& weights) {
    const RationalSeries first = row_series(forests, 2), back = inverse_of(forests, first);
    RationalSeries u(forests.size(), Rational(0));
    for (std::size_t j = 0; j < weights.size(); ++j) {
        const RationalSeries row = row_series(forests, 2 * static_cast<int>(j + 1));
        const RationalSeries log = logarithm_of(forests, orders::concatenation(forests, back, row));
        for (std::size_t w = 0; w < u.size(); ++w) u[w] += weights[j] * log[w];
    }
    return orders::concatenation(forests, first, orders::exponential_of(forests, u));
}

int group_order(int first, int columns) {
    const auto weights = lagrange_weights<Rational>(first, columns);
    return orders::flow_order(6, 0, [&](const OrderedForests& all) { return extrapolated_series(all, weights); });
}

SchemeOrders group_extrapolation_orders(const GroupExtrapolationScheme& scheme) {
    SchemeOrders found{.step = group_order(1, scheme.columns), .embedded = group_order(2, scheme.columns)};
    const orders::TableauOrders classical = orders::tableau_orders(gragg_tableau(scheme.columns));
    if (found.step == 6) found.step = classical.step;
    if (found.embedded == 6) found.embedded = classical.embedded;
    return found;
}

ClassicalScheme group_extrapolation_classical(const GroupExtrapolationScheme& scheme) {
    return classical_scheme(gragg_tableau(scheme.columns));
}

}  // namespace

KREISEL_SCHEME_FAMILY("extrapolation on the group", group_extrapolation_step, group_extrapolation_orders,
                      group_extrapolation_classical);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
