// SPDX-License-Identifier: BSD-3-Clause
#include "tests/judges/families/dense_chart.hpp"

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
    throw std::out_of_range("no dense chart of the coordinates " + std::get<std::string>(coordinates));
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
