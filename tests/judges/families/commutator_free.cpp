// SPDX-License-Identifier: BSD-3-Clause
//
// Commutator-free methods, methods/commutator_free/commutator_free.hpp: products of exponentials of combinations of
// slopes, every product written out from y_n. A pair has the error log(y^^{-1} y).
#include <Eigen/LU>

#include "tests/judges/conditions/commutator_free_series.hpp"
#include "tests/judges/families/scheme_family.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

using Factors = std::vector<std::vector<Coefficient>>;

/// All factors of a product, those of the stage it starts from first.
Factors written_out(const CommutatorFreeScheme& scheme, const ExponentialProduct& product) {
    Factors all;
    if (product.from > 1) all = written_out(scheme, scheme.stages.at(static_cast<std::size_t>(product.from - 1)));
    all.insert(all.end(), product.factors.begin(), product.factors.end());
    return all;
}

/// h = 1 and all slopes commute: the weights of the slopes.
std::vector<Real> classical_row(const Factors& factors) {
    std::vector<Real> row;
    for (const auto& factor : factors) {
        row.resize(std::max(row.size(), factor.size()), 0);
        for (std::size_t j = 0; j < factor.size(); ++j) row[j] += value(factor[j]);
    }
    return row;
}

DensePoint point_of(const Factors& factors, const ScriptedStep& given, const std::vector<VecX>& slopes) {
    DensePoint point = given.start;
    for (const auto& factor : factors) {
        const VecX u = given.h * combination(factor, slopes, given.start.v.size());
        point.q = MatX(point.q * dense_exp(given.group.hat(u)));
        point.v += given.h * combination(factor, given.script, given.start.v.size());
    }
    for (const Real& weight : classical_row(factors)) point.t += weight * given.h;
    return point;
}

DenseStep commutator_free_step(const CommutatorFreeScheme& scheme, const ScriptedStep& given) {
    DenseStep step;
    std::vector<VecX> slopes;
    for (const ExponentialProduct& stage : scheme.stages) {
        step.stages.push_back(point_of(written_out(scheme, stage), given, slopes));
        slopes.push_back(step.stages.back().v);
    }
    step.result = point_of(written_out(scheme, scheme.result), given, slopes);
    if (scheme.embedded.factors.empty()) return step;
    const DensePoint other = point_of(written_out(scheme, scheme.embedded), given, slopes);
    const MatX apart = other.q.partialPivLu().solve(step.result.q);
    step.error = joined(given.group.vee(dense_log(apart)), step.result.v - other.v);
    return step;
}

SchemeOrders commutator_free_orders(const CommutatorFreeScheme& scheme) {
    orders::CommutatorFree<orders::Rational> method;
    bool digits = false;
    const auto exact = [&](const ExponentialProduct& product) {
        orders::CommutatorFree<orders::Rational>::Product all;
        for (const auto& factor : written_out(scheme, product)) {
            all.emplace_back();
            for (const Coefficient& entry : factor) {
                digits = digits || entry.digits;
                all.back().push_back(orders::exact(entry));
            }
        }
        return all;
    };
    for (const ExponentialProduct& stage : scheme.stages) method.stages.push_back(exact(stage));
    method.result = exact(scheme.result);
    SchemeOrders found{.step = orders::commutator_free_order(method, orders::rounding(digits))};
    if (scheme.embedded.factors.empty()) return found;
    method.result = exact(scheme.embedded);
    found.embedded = orders::commutator_free_order(method, orders::rounding(digits));
    return found;
}

ClassicalScheme commutator_free_classical(const CommutatorFreeScheme& scheme) {
    ClassicalScheme classical;
    for (const auto& stage : scheme.stages) classical.a.push_back(classical_row(written_out(scheme, stage)));
    classical.b = classical_row(written_out(scheme, scheme.result));
    classical.b.resize(scheme.stages.size(), 0);
    return classical;
}

}  // namespace

KREISEL_SCHEME_FAMILY("commutator-free", commutator_free_step, commutator_free_orders, commutator_free_classical);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
