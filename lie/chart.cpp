// SPDX-License-Identifier: BSD-3-Clause
#include "lie/chart.hpp"

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "lie/small_angle.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

class ExpChart final : public Chart {
  public:
    explicit ExpChart(const Group& group) : group_(group) {}
    void append(const Real* q, const Real* u, Real* out) const override { group_.append_exp(q, u, out); }
    bool pull_back(const Real* u, const Real* v, Real* out) override { return group_.dexpinv_left(u, v, out); }

  private:
    const Group& group_;
};

/// (-1)^p B_p / p!: 1, 1/2, 1/12, 0, -1/720, ... (B_1 = -1/2). The sign (-1)^p makes the series left-trivialised.
Real left_coefficient(int p) {
    if (p == 0) return 1;
    if (p == 1) return Real(1) / 2;
    if (p % 2 == 1) return 0;
    const Real magnitude = Real(series::bernoulli[static_cast<std::size_t>(p / 2 - 1)]);
    return p % 4 == 2 ? magnitude : -magnitude;
}

class TruncatedExpChart final : public Chart {
  public:
    TruncatedExpChart(const Group& group, int brackets)
        : group_(group), power_(static_cast<std::size_t>(group.dim())), sum_(power_.size()) {
        for (int p = 0; p <= brackets; ++p) coefficients_.push_back(left_coefficient(p));
    }
    void append(const Real* q, const Real* u, Real* out) const override { group_.append_exp(q, u, out); }
    bool pull_back(const Real* u, const Real* v, Real* out) override {
        std::copy_n(v, power_.size(), power_.begin());
        sum_ = power_;
        for (std::size_t p = 1; p < coefficients_.size(); ++p) {
            group_.bracket(u, power_.data(), power_.data());
            for (std::size_t i = 0; i < sum_.size(); ++i) sum_[i] += coefficients_[p] * power_[i];
        }
        std::copy(sum_.begin(), sum_.end(), out);
        return true;
    }

  private:
    const Group& group_;
    std::vector<Real> power_, sum_, coefficients_;
};

class CayleyChart final : public Chart {
  public:
    explicit CayleyChart(const Group& group) : group_(group) {}
    void append(const Real* q, const Real* u, Real* out) const override { group_.append_cay(q, u, out); }
    bool pull_back(const Real* u, const Real* v, Real* out) override {
        group_.dcayinv_left(u, v, out);
        return true;
    }

  private:
    const Group& group_;
};

}  // namespace

std::unique_ptr<Chart> exp_chart(const Group& group) { return std::make_unique<ExpChart>(group); }

std::unique_ptr<Chart> truncated_exp_chart(const Group& group, int brackets) {
    if (brackets < 0 || brackets > max_brackets) throw std::invalid_argument("dexpinv takes 0 to 30 brackets");
    return std::make_unique<TruncatedExpChart>(group, brackets);
}

std::unique_ptr<Chart> cayley_chart(const Group& group) { return std::make_unique<CayleyChart>(group); }

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
