// SPDX-License-Identifier: BSD-3-Clause
#include "lie/chart.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "lie/small_angle.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// (-1)^p B_p / p!: 1, 1/2, 1/12, 0, -1/720, ... (B_1 = -1/2). The sign (-1)^p makes the series left-trivialised.
Real left_coefficient(int p) {
    if (p == 0) return 1;
    if (p == 1) return Real(1) / 2;
    if (p % 2 == 1) return 0;
    const Real magnitude = Real(series::bernoulli[static_cast<std::size_t>(p / 2 - 1)]);
    return p % 4 == 2 ? magnitude : -magnitude;
}

}  // namespace

TruncatedExpChart::TruncatedExpChart(const Group& group, int brackets)
    : group_(&group), power_(static_cast<std::size_t>(group.dim())), sum_(power_.size()) {
    if (brackets < 0 || brackets > max_brackets)
        throw std::invalid_argument("dexpinv takes 0 to " + std::to_string(max_brackets) + " brackets");
    for (int p = 0; p <= brackets; ++p) coefficients_.push_back(left_coefficient(p));
}

bool TruncatedExpChart::pull_back(const Real* u, const Real* v, Real* out) {
    std::copy_n(v, power_.size(), power_.begin());
    sum_ = power_;
    for (std::size_t p = 1; p < coefficients_.size(); ++p) {
        group_->bracket(u, power_.data(), power_.data());
        for (std::size_t i = 0; i < sum_.size(); ++i) sum_[i] += coefficients_[p] * power_[i];
    }
    std::copy(sum_.begin(), sum_.end(), out);
    return group_->in_exp_chart(u);  // beyond, the series diverges as the closed form does
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
