// SPDX-License-Identifier: BSD-3-Clause
#include "tests/judges/steps/declared_step.hpp"

#include "methods/tableaus/bound_tableau.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// sum_j weights_j vectors_j, over as many as there are weights.
VecX combination(const std::vector<Coefficient>& weights, const std::vector<VecX>& vectors, Eigen::Index size) {
    VecX sum = VecX::Zero(size);
    for (std::size_t j = 0; j < weights.size(); ++j) sum += value(weights[j]) * vectors[j];
    return sum;
}

Real node(const std::vector<Coefficient>& row) {
    Real c = 0;
    for (const auto& entry : row) c += value(entry);
    return c;
}

/// Both families: `move(weights)` is the configuration that the slopes so far lead to, `slope` is given each new stage
/// velocity. Velocities are additive in both.
template <class Move, class Slope>
DenseStep evaluate(const Tableau& tableau, const std::vector<VecX>& script, const Real& h, const DensePoint& start,
                   Move move, Slope slope) {
    const auto velocity = [&](const std::vector<Coefficient>& weights) -> VecX {
        return start.v + h * combination(weights, script, start.v.size());
    };
    DenseStep step;
    for (const auto& row : tableau.a) {
        step.stages.push_back({start.t + node(row) * h, move(row), velocity(row)});
        slope(row, step.stages.back().v);
    }
    step.result = {start.t + h, move(tableau.b), velocity(tableau.b)};
    return step;
}

}  // namespace

DenseChart dense_chart(const MatrixGroup& group, const OptionValues& options, int order) {
    const auto option = [&](const char* name, const OptionValue& standard) {
        return options.count(name) ? options.at(name) : standard;
    };
    const auto exp = [group](const VecX& u) { return dense_exp(group.hat(u)); };
    if (option("coordinates", "exp") == OptionValue("cayley"))
        return {[group](const VecX& u) { return dense_cay(group.hat(u)); },
                [group](const VecX& u, const VecX& v) { return dense_dcayinv_left(group, u, v); }};
    const OptionValue dexpinv = option("dexpinv", "exact");
    if (dexpinv == OptionValue("exact"))
        return {exp, [group](const VecX& u, const VecX& v) { return dense_dexpinv_left(group, u, v); }};
    const int brackets = dexpinv == OptionValue("seed") ? order - 1 : static_cast<int>(std::get<long>(dexpinv));
    return {exp, [group, brackets](const VecX& u, const VecX& v) {
                return dense_truncated_dexpinv_left(group, u, v, brackets);
            }};
}

DenseStep dense_munthe_kaas(const MatrixGroup& group, const DenseChart& chart, const Tableau& tableau,
                            const std::vector<VecX>& script, const Real& h, const DensePoint& start) {
    std::vector<VecX> slopes;
    const auto coordinates = [&](const std::vector<Coefficient>& weights) -> VecX {
        return h * combination(weights, slopes, group.group->dim());
    };
    return evaluate(
        tableau, script, h, start,
        [&](const std::vector<Coefficient>& weights) { return MatX(start.q * chart.psi(coordinates(weights))); },
        [&](const std::vector<Coefficient>& row, const VecX& v) {
            slopes.push_back(chart.pull_back(coordinates(row), v));
        });
}

DenseStep dense_crouch_grossman(const MatrixGroup& group, const Tableau& tableau, const std::vector<VecX>& script,
                                const Real& h, const DensePoint& start) {
    std::vector<VecX> slopes;
    const auto product = [&](const std::vector<Coefficient>& weights) {
        MatX q = start.q;
        for (std::size_t j = 0; j < weights.size(); ++j)
            q = MatX(q * dense_exp(group.hat(h * value(weights[j]) * slopes[j])));
        return q;
    };
    return evaluate(tableau, script, h, start, product,
                    [&](const std::vector<Coefficient>&, const VecX& v) { slopes.push_back(v); });
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
