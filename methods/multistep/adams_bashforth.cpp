// SPDX-License-Identifier: BSD-3-Clause
#include "methods/multistep/adams_bashforth.hpp"

#include <algorithm>
#include <utility>

#include "methods/contract/integrator.hpp"
#include "methods/contract/state_space.hpp"
#include "methods/tableaus/bound_tableau.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

class AdamsBashforth final : public Integrator {
  public:
    AdamsBashforth(System& system, const std::vector<Coefficient>& weights)
        : space_(system),
          dim_(static_cast<std::size_t>(space_.group().dim())),
          size_(static_cast<std::size_t>(space_.group().size())),
          starter_(method("rkmk/rk4")
                       .factory.make(system, with_defaults({}, method("rkmk/rk4").description.options),
                                     method("rkmk/rk4").description)),
          points_(weights.size(), std::vector<Real>(size_)),
          slopes_(weights.size(), std::vector<Real>(dim_)),
          inverse_(size_),
          apart_(size_),
          sigma_(dim_),
          u_(dim_) {
        for (const Coefficient& weight : weights) weights_.push_back(value(weight));
    }

    Status start(const Real&, const Real*) override {
        known_ = 0;
        return Status::ok;
    }

    Status step(const Real& t, const Real& h, Real* y) override {
        if (h != h_) known_ = 0;
        h_ = h;
        const std::size_t before = std::exchange(known_, 0);  // kept again if this step succeeds
        std::rotate(points_.rbegin(), points_.rbegin() + 1, points_.rend());
        std::rotate(slopes_.rbegin(), slopes_.rbegin() + 1, slopes_.rend());
        std::copy_n(y, size_, points_[0].begin());
        Status status = space_.slope(t, y, slopes_[0].data());
        if (status != Status::ok) return status;
        status = before + 1 < weights_.size() ? begin(t, h, y) : advance(h, y);
        if (status == Status::ok) known_ = std::min(before + 1, weights_.size() - 1);
        return status;
    }

  private:
    Status begin(const Real& t, const Real& h, Real* y) {
        const long counted = starter_->work().exponentials;
        const Status status = starter_->step(t, h, y);
        work_.exponentials += starter_->work().exponentials - counted;
        return status;
    }

    Status advance(const Real& h, Real* y) {
        const Group& group = space_.group();
        for (std::size_t i = 0; i < dim_; ++i) u_[i] = h * weights_[0] * slopes_[0][i];
        group.inverse(y, inverse_.data());
        for (std::size_t j = 1; j < weights_.size(); ++j) {
            group.multiply(inverse_.data(), points_[j].data(), apart_.data());
            group.log(apart_.data(), sigma_.data());
            if (!group.dexpinv_left(sigma_.data(), slopes_[j].data(), sigma_.data())) return Status::left_chart;
            const Real w = h * weights_[j];
            for (std::size_t i = 0; i < dim_; ++i) u_[i] += w * sigma_[i];
        }
        group.append_exp(y, u_.data(), y);
        ++work_.exponentials;
        return Status::ok;
    }

    StateSpace space_;
    std::size_t dim_, size_;
    std::unique_ptr<Integrator> starter_;
    std::vector<Real> weights_;
    std::vector<std::vector<Real>> points_, slopes_;  // of the states j steps ago, from 0
    std::vector<Real> inverse_, apart_, sigma_, u_;
    std::size_t known_ = 0;  // states before the one a step starts from
    Real h_ = 0;             // step that they are apart
};

}  // namespace

Factory adams_bashforth(const std::vector<Coefficient>& weights) {
    Factory factory;
    factory.make = [weights](System& system, const OptionValues&, const MethodDescription&) {
        return std::make_unique<AdamsBashforth>(system, weights);
    };
    factory.stages = 1;
    factory.takes_actions = true;
    return factory;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
