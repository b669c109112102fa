// SPDX-License-Identifier: BSD-3-Clause
#include "engine/reference/taylor/force_series.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// With w = R omega in space axes: -damping (w_second - w_first) on the second.
class RotationalDamperSeries final : public ForceSeries {
  public:
    RotationalDamperSeries(const RotationalDamper& damper, const BodyAt& at)
        : damper_(damper), first_(at(damper.first)), second_(at(damper.second)) {}

    void act(std::size_t k) override {
        const Vec3 turning = product(second_.R, second_.omega, k) - product(first_.R, first_.omega, k);
        first_.act(Vec3::Zero(), damper_.damping * turning, k);
        second_.act(Vec3::Zero(), -damper_.damping * turning, k);
    }

  private:
    RotationalDamper damper_;
    BodySeries &first_, &second_;
};

const SeriesRegistration<RotationalDamper, RotationalDamperSeries> rotational_damper_series;

}  // namespace

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
