// SPDX-License-Identifier: BSD-3-Clause
#include "lie/chart.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

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

namespace {

/// x <- A^{-1} x by Gaussian elimination with row interchanges, A of n columns one after another, which is destroyed.
/// Returns det A.
Real solve_in_place(std::vector<Real>& A, std::size_t n, Real* x) {
    const auto entry = [&](std::size_t i, std::size_t k) -> Real& { return A[k * n + i]; };
    Real determinant = 1;
    for (std::size_t k = 0; k < n; ++k) {
        std::size_t pivot = k;
        for (std::size_t i = k + 1; i < n; ++i)
            if (abs(entry(i, k)) > abs(entry(pivot, k))) pivot = i;
        if (pivot != k) {
            for (std::size_t j = k; j < n; ++j) std::swap(entry(k, j), entry(pivot, j));
            std::swap(x[k], x[pivot]);
            determinant = -determinant;
        }
        determinant *= entry(k, k);
        for (std::size_t i = k + 1; i < n; ++i) {
            const Real factor = entry(i, k) / entry(k, k);
            for (std::size_t j = k + 1; j < n; ++j) entry(i, j) -= factor * entry(k, j);
            x[i] -= factor * x[k];
        }
    }
    for (std::size_t k = n; k-- > 0;) {
        for (std::size_t j = k + 1; j < n; ++j) x[k] -= entry(k, j) * x[j];
        x[k] /= entry(k, k);
    }
    return determinant;
}

}  // namespace

SecondKindChart::SecondKindChart(const Group& group)
    : group_(&group),
      n_(static_cast<std::size_t>(group.dim())),
      factor_(static_cast<std::size_t>(group.factor_dim())),
      direction_(n_),
      rest_(static_cast<std::size_t>(group.size())),
      columns_(n_ * factor_),
      system_(factor_ * factor_) {}

const Real* SecondKindChart::along(std::size_t k, const Real* u, int sign) {
    std::fill(direction_.begin(), direction_.end(), Real(0));
    for (std::size_t i = k; i < n_; i += factor_) direction_[i] = sign * u[i];
    return direction_.data();
}

void SecondKindChart::append(const Real* q, const Real* u, Real* out) {
    for (std::size_t k = 0; k < factor_; ++k) group_->append_exp(k == 0 ? q : out, along(k, u, 1), out);
}

bool SecondKindChart::pull_back(const Real* u, const Real* v, Real* out) {
    group_->identity(rest_.data());  // r_k^{-1} = exp(-u_d e_d) ... exp(-u_{k+1} e_{k+1})
    for (std::size_t k = factor_; k-- > 0;) {
        std::fill(direction_.begin(), direction_.end(), Real(0));
        for (std::size_t i = k; i < n_; i += factor_) direction_[i] = 1;
        group_->Ad(rest_.data(), direction_.data(), columns_.data() + k * n_);
        group_->append_exp(rest_.data(), along(k, u, -1), rest_.data());
    }
    if (out != v) std::copy_n(v, n_, out);
    bool inside = true;
    for (std::size_t first = 0; first < n_; first += factor_) {
        for (std::size_t k = 0; k < factor_; ++k)
            std::copy_n(columns_.data() + k * n_ + first, factor_, system_.data() + k * factor_);
        // For rotations, the cosine of the second angle.
        inside &= 64 * solve_in_place(system_, factor_, out + first) >= 1;
    }
    return inside;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
