// SPDX-License-Identifier: BSD-3-Clause
#include "methods/cautionary/right_series.hpp"

#include <algorithm>

#include "mechanics/system.hpp"
#include "methods/contract/integrator.hpp"
#include "methods/tableaus/bound_tableau.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

class RightSeries final : public Integrator {
  public:
    RightSeries(System& system, const Tableau& tableau)
        : system_(system),
          n_(static_cast<std::size_t>(system.velocities())),
          stride_(padded(2 * n_)),
          tableau_(tableau, stride_),
          u_(stride_),
          slopes_(stride_ * tableau_.stages()),
          stage_(static_cast<std::size_t>(system.state_group().size())) {}

    Status step(const Real& t, const Real& h, Real* y) override {
        for (std::size_t i = 0; i < tableau_.stages_of_step; ++i) {
            Real* slope = slopes_.data() + i * stride_;
            std::fill(u_.begin(), u_.end(), Real(0));
            std::copy_n(y, stage_.size(), stage_.begin());
            if (!tableau_.a[i].empty()) append(tableau_.a[i], h, stage_.data());
            const Status status = system_.vector_field(t + tableau_.c[i] * h, stage_.data(), slope);
            if (status != Status::ok) return status;
            // dexp^{-1}_u is the left-trivialised inverse at -u.
            for (std::size_t k = 0; k < n_; ++k) u_[k] = -u_[k];
            if (!system_.group().dexpinv_left(u_.data(), slope, slope)) return Status::left_chart;
        }
        append(tableau_.b, h, y);
        return Status::ok;
    }

  private:
    /// y <- y exp(u) with u = h sum_j weight_j k~_j.
    void append(const Combination& weights, const Real& h, Real* y) {
        combine(weights, h, slopes_.data(), stride_, u_.data());
        system_.state_group().append_exp(y, u_.data(), y);
        ++work_.exponentials;
    }

    System& system_;
    std::size_t n_, stride_;
    BoundTableau tableau_;
    std::vector<Real> u_, slopes_, stage_;
};

}  // namespace

Factory right_series(const Tableau& tableau) {
    Factory factory;
    factory.make = [tableau](System& system, const OptionValues&, const MethodDescription&) {
        return std::make_unique<RightSeries>(system, tableau);
    };
    factory.stages = stages_of_step(tableau);
    factory.scheme = Scheme(RightSeriesScheme{tableau});
    return factory;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
