// SPDX-License-Identifier: BSD-3-Clause
#include "engine/reference/taylor/force_series.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// With d from the first point to the second: strength d / |d|^3 on the first.
class AttractionSeries final : public ForceSeries {
  public:
    AttractionSeries(const Attraction& attraction, const BodyAt& at)
        : attraction_(attraction),
          first_(at(attraction.first)),
          second_(at(attraction.second)),
          arm_first_(first_, attraction.r_first),
          arm_second_(second_, attraction.r_second),
          d_(vectors(first_)),
          scaled_(d_),
          pull_(d_),
          square_(scalars(first_)),
          length_(square_),
          cube_(square_) {}

    void act(std::size_t k) override {
        arm_first_.update(k), arm_second_.update(k);
        d_[k] = second_.x[k] + arm_second_[k] - first_.x[k] - arm_first_[k];
        square_[k] = dot(d_, d_, k);
        length_[k] = square_root(square_, length_, k);
        cube_[k] = product(square_, length_, k);
        scaled_[k] = attraction_.strength * d_[k];
        pull_[k] = quotient(scaled_, cube_, pull_, k);
        first_.act(pull_[k], cross(arm_first_.series(), pull_, k), k);
        second_.act(-pull_[k], -cross(arm_second_.series(), pull_, k), k);
    }

  private:
    Attraction attraction_;
    BodySeries &first_, &second_;
    Attached arm_first_, arm_second_;
    Vectors d_, scaled_, pull_;
    Scalars square_, length_, cube_;
};

const SeriesRegistration<Attraction, AttractionSeries> attraction_series;

}  // namespace

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
