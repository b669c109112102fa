// SPDX-License-Identifier: BSD-3-Clause
#include "methods/extrapolation/chart_midpoint.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "lie/chart.hpp"
#include "mechanics/system.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// On TG = G x R^n the velocity factor is additive, and the chart is needed on G only.
class ChartMidpoint final : public ExtrapolationBase {
  public:
    ChartMidpoint(System& system, Work& work)
        : ExtrapolationBase(work),
          system_(system),
          chart_(system.group()),
          n_(static_cast<std::size_t>(system.velocities())),
          size_(static_cast<std::size_t>(system.group().size())),
          first_(2 * n_),
          slope_(2 * n_),
          before_(2 * n_),
          now_(2 * n_),
          stage_(size_ + n_) {}

    Status begin(const Real& t, const Real& H, const Real* y, bool known) override {
        t_ = t, H_ = H, y_ = y;
        return known ? Status::ok : system_.vector_field(t, y, first_.data());
    }

    Status row(int n, Real* u) override {
        const Real h = H_ / n;
        for (std::size_t i = 0; i < 2 * n_; ++i) before_[i] = 0, now_[i] = h * first_[i];
        for (int i = 1; i < n; ++i) {
            if (const Status status = slope(t_ + i * h); status != Status::ok) return status;
            const Real h2 = 2 * h;
            for (std::size_t j = 0; j < 2 * n_; ++j) before_[j] += h2 * slope_[j];
            std::swap(before_, now_);
        }
        std::copy(now_.begin(), now_.end(), u);
        return Status::ok;
    }

    void state(const Real* u, Real* y) override {
        append(u, y);
        ++work_.exponentials;
    }

  private:
    void append(const Real* u, Real* out) {
        const Real* v = y_ + size_;
        chart_.append(y_, u, out);
        u += n_, out += size_;
        KREISEL_ELEMENTWISE
        for (std::size_t i = 0; i < n_; ++i) out[i] = v[i] + u[i];
    }

    /// k~ at the coordinates now_.
    Status slope(const Real& t) {
        append(now_.data(), stage_.data());
        ++work_.exponentials;
        const Real* v = stage_.data() + size_;
        const Status status = system_.evaluate(t, stage_.data(), v, slope_.data() + n_);
        if (status != Status::ok) return status;
        return chart_.pull_back(now_.data(), v, slope_.data()) ? Status::ok : Status::left_chart;
    }

    System& system_;
    ExpChart chart_;
    std::size_t n_, size_;
    std::vector<Real> first_, slope_, before_, now_, stage_;
    Real t_ = 0, H_ = 0;
    const Real* y_ = nullptr;
};

}  // namespace

std::unique_ptr<ExtrapolationBase> chart_midpoint(System& system, Work& work) {
    return std::make_unique<ChartMidpoint>(system, work);
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
