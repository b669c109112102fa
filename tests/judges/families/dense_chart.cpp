// SPDX-License-Identifier: BSD-3-Clause
#include "tests/judges/families/dense_chart.hpp"

#include <Eigen/LU>
#include <stdexcept>

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

DenseChart exp_chart(const MatrixGroup& group, const OptionValue& dexpinv, int order) {
    const auto exp = [group](const VecX& u) { return dense_exp(group.hat(u)); };
    if (dexpinv == OptionValue("exact"))
        return {exp, [group](const VecX& u, const VecX& v) { return dense_dexpinv_left(group, u, v); }};
    const int brackets = dexpinv == OptionValue("seed") ? order - 1 : static_cast<int>(std::get<long>(dexpinv));
    return {exp, [group, brackets](const VecX& u, const VecX& v) {
                return dense_truncated_dexpinv_left(group, u, v, brackets);
            }};
}

/// psi(u) = exp(u_1 e_1) ... exp(u_n e_n); v = sum_k u_k' r_k^{-1} e_k r_k with the product r_k of the factors after k.
DenseChart second_kind_chart(const MatrixGroup& group) {
    const auto factor = [group](const VecX& u, Eigen::Index k) {
        return dense_exp(group.hat(u[k] * VecX::Unit(u.size(), k)));
    };
    const auto psi = [factor](const VecX& u) {
        MatX q = factor(u, 0);
        for (Eigen::Index k = 1; k < u.size(); ++k) q = MatX(q * factor(u, k));
        return q;
    };
    const auto pull_back = [group, factor](const VecX& u, const VecX& v) -> VecX {
        MatX velocities(u.size(), u.size()), rest = MatX::Identity(group.hat(u).rows(), group.hat(u).rows());
        for (Eigen::Index k = u.size() - 1; k >= 0; --k) {
            const MatX e = group.hat(VecX::Unit(u.size(), k));
            velocities.col(k) = group.vee(rest.partialPivLu().solve(MatX(e * rest)));
            rest = MatX(factor(u, k) * rest);
        }
        return velocities.fullPivLu().solve(v);
    };
    return {psi, pull_back};
}

}  // namespace

DenseChart dense_chart(const MatrixGroup& group, const OptionValues& options, int order) {
    const auto option = [&](const char* name, const OptionValue& standard) {
        return options.count(name) ? options.at(name) : standard;
    };
    const OptionValue coordinates = option("coordinates", "exp");
    if (coordinates == OptionValue("exp")) return exp_chart(group, option("dexpinv", "exact"), order);
    if (coordinates == OptionValue("cayley"))
        return {[group](const VecX& u) { return dense_cay(group.hat(u)); },
                [group](const VecX& u, const VecX& v) { return dense_dcayinv_left(group, u, v); }};
    if (coordinates == OptionValue("second_kind")) return second_kind_chart(group);
    throw std::out_of_range("no dense chart of the coordinates " + std::get<std::string>(coordinates));
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
