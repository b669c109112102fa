// SPDX-License-Identifier: BSD-3-Clause
#include "engine/reference/taylor/point_pair.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// With d from the first point to the second: strength d / |d|^3 on the first.
class AttractionSeries final : public ForceSeries {
  public:
    AttractionSeries(const Attraction& attraction, const BodyAt& at)
        : strength_(attraction.strength),
          points_(attraction, at),
          scaled_(points_.vectors()),
          pull_(scaled_),
          cube_(points_.scalars()) {}

    void act(std::size_t k) override {
        points_.update(k), points_.measure(k);
        cube_[k] = product(points_.square(), points_.length(), k);
        scaled_[k] = strength_ * points_.d()[k];
        pull_[k] = quotient(scaled_, cube_, pull_, k);
        points_.pull(pull_, k);
    }

  private:
    Real strength_;
    PointPair points_;
    Vectors scaled_, pull_;
    Scalars cube_;
};

const SeriesRegistration<Attraction, AttractionSeries> attraction_series;

}  // namespace

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
