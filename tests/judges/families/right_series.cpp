// SPDX-License-Identifier: BSD-3-Clause
//
// Munthe-Kaas lifts with the right-trivialised series on left kinematics, methods/cautionary/right_series.hpp. One step
// by dense matrices; the order from series in words of elementary differentials, where dexp^{-1} is its series of
// commutators, so that what the mixed signs leave is found and not asserted.
#include "methods/cautionary/right_series.hpp"

#include "tests/judges/conditions/bracket_series.hpp"
#include "tests/judges/families/scheme_family.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

DenseStep right_series_step(const RightSeriesScheme& scheme, const ScriptedStep& given) {
    const Eigen::Index n = given.group.group->dim();
    std::vector<VecX> slopes;
    const auto coordinates = [&](const std::vector<Coefficient>& weights) -> VecX {
        return given.h * combination(weights, slopes, n);
    };
    const auto move = [&](const std::vector<Coefficient>& weights) {
        return MatX(given.start.q * dense_exp(given.group.hat(coordinates(weights))));
    };
    return tableau_step(scheme.tableau, given, move, [&](const std::vector<Coefficient>& row, const VecX& v) {
        slopes.push_back(dense_dexpinv_left(given.group, VecX(-coordinates(row)), v));
    });
}

using WordSeries = orders::Series<orders::Rational>;

/// dexp_u^{-1}(k) = sum_p B_p/p! ad_u^p k, B_p/p! = 1, -1/2, 1/12, 0, -1/720: all there is of it up to five nodes.
WordSeries right_dexpinv(const orders::OrderedForests& forests, const WordSeries& u, WordSeries k) {
    WordSeries sum(forests.size(), 0);
    for (const orders::Rational& coefficient : {orders::Rational(1), orders::Rational(-1, 2), orders::Rational(1, 12),
                                                orders::Rational(0), orders::Rational(-1, 720)}) {
        for (std::size_t w = 0; w < sum.size(); ++w) sum[w] += coefficient * k[w];
        const WordSeries ahead = orders::concatenation(forests, u, k), behind = orders::concatenation(forests, k, u);
        for (std::size_t w = 0; w < sum.size(); ++w) k[w] = ahead[w] - behind[w];
    }
    return sum;
}

WordSeries right_series_of_step(const orders::OrderedForests& forests,
                                const orders::NumericTableau<orders::Rational>& tableau) {
    std::vector<WordSeries> slopes;
    const auto coordinates = [&](const std::vector<orders::Rational>& weights) {
        WordSeries u(forests.size(), 0);
        for (std::size_t j = 0; j < weights.size(); ++j)
            for (std::size_t w = 0; w < u.size(); ++w) u[w] += weights[j] * slopes[j][w];
        return u;
    };
    for (const auto& row : tableau.a) {
        const WordSeries u = coordinates(row);
        slopes.push_back(right_dexpinv(forests, u, orders::slope_at(forests, orders::exponential_of(forests, u))));
    }
    return orders::exponential_of(forests, coordinates(tableau.b));
}

SchemeOrders right_series_orders(const RightSeriesScheme& scheme) {
    const auto tableau = orders::exact(scheme.tableau);
    return {.step = orders::flow_order(5, orders::rounding(scheme.tableau), [&](const orders::OrderedForests& forests) {
                return right_series_of_step(forests, tableau);
            })};
}

ClassicalScheme right_series_classical(const RightSeriesScheme& scheme) { return classical_scheme(scheme.tableau); }

}  // namespace

KREISEL_SCHEME_FAMILY("Munthe-Kaas of mixed trivialisations", right_series_step, right_series_orders,
                      right_series_classical);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
