// SPDX-License-Identifier: BSD-3-Clause
//
// Crouch-Grossman methods, methods/crouch_grossman/crouch_grossman.hpp:
//   y_{n+1} = y_n exp(h b_1 K_1) ... exp(h b_s K_s).  A pair has the error log(y^^{-1} y).
#include <Eigen/LU>

#include "tests/judges/conditions/crouch_grossman_conditions.hpp"
#include "tests/judges/families/scheme_family.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

DenseStep crouch_grossman_step(const CrouchGrossmanScheme& scheme, const ScriptedStep& given) {
    std::vector<VecX> slopes;
    const auto product = [&](const std::vector<Coefficient>& weights) {
        MatX q = given.start.q;
        for (std::size_t j = 0; j < weights.size(); ++j)
            q = MatX(q * dense_exp(given.group.hat(given.h * value(weights[j]) * slopes[j])));
        return q;
    };
    const Tableau& tableau = scheme.tableau;
    DenseStep step = tableau_step(tableau, given, product,
                                  [&](const std::vector<Coefficient>&, const VecX& v) { slopes.push_back(v); });
    if (tableau.b_hat.empty()) return step;
    const MatX apart = product(tableau.b_hat).partialPivLu().solve(step.result.q);
    const VecX v = given.start.v + given.h * combination(tableau.b_hat, given.script, given.start.v.size());
    step.error = joined(given.group.vee(dense_log(apart)), step.result.v - v);
    return step;
}

SchemeOrders crouch_grossman_orders(const CrouchGrossmanScheme& scheme) {
    const auto [step, embedded] =
        orders::crouch_grossman_orders(orders::exact(scheme.tableau), orders::rounding(scheme.tableau));
    return {.step = step, .embedded = embedded};
}

ClassicalScheme crouch_grossman_classical(const CrouchGrossmanScheme& scheme) {
    return classical_scheme(scheme.tableau);
}

}  // namespace

KREISEL_SCHEME_FAMILY("Crouch-Grossman", crouch_grossman_step, crouch_grossman_orders, crouch_grossman_classical);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
