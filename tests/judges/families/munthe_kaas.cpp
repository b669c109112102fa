// SPDX-License-Identifier: BSD-3-Clause
//
// Munthe-Kaas lifts of explicit tableaus, methods/rkmk/rkmk.hpp: y_{n+1} = y_n psi(h sum b_j k~_j), in the chart given
// by the options. They have the order of their tableau [munthekaas1999], and a pair the error u - u^ in that chart.
#include "methods/conditions/tableau_orders.hpp"
#include "tests/judges/families/dense_chart.hpp"
#include "tests/judges/families/scheme_family.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

DenseStep munthe_kaas_step(const MuntheKaasScheme& scheme, const ScriptedStep& given) {
    const Tableau& tableau = scheme.tableau;
    const DenseChart chart = dense_chart(given.group, given.options, given.order);
    const Eigen::Index n = given.group.group->dim();
    std::vector<VecX> slopes;
    const auto coordinates = [&](const std::vector<Coefficient>& weights) -> VecX {
        return given.h * combination(weights, slopes, n);
    };
    const auto move = [&](const std::vector<Coefficient>& weights) {
        return MatX(given.start.q * chart.psi(coordinates(weights)));
    };
    const auto slope = [&](const std::vector<Coefficient>& row, const VecX& v) {
        slopes.push_back(chart.pull_back(coordinates(row), v));
    };
    DenseStep step = tableau_step(tableau, given, move, slope);
    if (tableau.b_hat.empty()) return step;
    const auto difference = [&](const std::vector<VecX>& vectors) -> VecX {
        return given.h * (combination(tableau.b, vectors, n) - combination(tableau.b_hat, vectors, n));
    };
    step.error = joined(difference(slopes), difference(given.script));
    return step;
}

SchemeOrders munthe_kaas_orders(const MuntheKaasScheme& scheme) {
    const orders::TableauOrders found = orders::tableau_orders(scheme.tableau);
    return {.step = found.step, .embedded = found.embedded, .dense = orders::dense_order(scheme.tableau)};
}

ClassicalScheme munthe_kaas_classical(const MuntheKaasScheme& scheme) { return classical_scheme(scheme.tableau); }

}  // namespace

KREISEL_SCHEME_FAMILY("Munthe-Kaas", munthe_kaas_step, munthe_kaas_orders, munthe_kaas_classical);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
