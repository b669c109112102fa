// SPDX-License-Identifier: BSD-3-Clause
#include "engine/reference/taylor/force_series.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// With P a point of the second body, and d from the mass centre of the first to P: the point of the first body that is
/// at P moves with v_first + w_first x d, so that P slips past it by d' - w_first x d. The force -damping times that
/// acts on the second body at P.
class DamperSeries final : public ForceSeries {
  public:
    DamperSeries(const Damper& damper, const BodyAt& at)
        : damper_(damper),
          first_(at(damper.first)),
          second_(at(damper.second)),
          arm_(second_, damper.r_second),
          d_(vectors(first_)),
          turning_(d_),
          force_(d_) {}

    void start(const Real&) override { update(0); }

    void act(std::size_t k) override {
        update(k + 1);
        turning_[k] = product(first_.R, first_.omega, k);
        force_[k] = -damper_.damping * (rate(d_, k) - cross(turning_, d_, k));
        first_.act(-force_[k], -cross(d_, force_, k), k);
        second_.act(force_[k], cross(arm_.series(), force_, k), k);
    }

  private:
    void update(std::size_t i) {
        arm_.update(i);
        d_[i] = second_.x[i] + arm_[i] - first_.x[i];
    }

    Damper damper_;
    BodySeries &first_, &second_;
    Attached arm_;
    Vectors d_, turning_, force_;
};

const SeriesRegistration<Damper, DamperSeries> damper_series;

}  // namespace

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
