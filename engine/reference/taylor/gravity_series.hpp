// SPDX-License-Identifier: BSD-3-Clause
//
// Gravity on one body as a power series in time.
#pragma once

#include "engine/reference/taylor/force_series.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

class GravitySeries final : public ForceSeries {
  public:
    GravitySeries(const Gravity& gravity, const Real& mass, BodySeries& body)
        : gravity_(gravity), mass_(mass), body_(body), factor_(scalars(body)) {}

    void start(const Real& t) override { modulate(gravity_.amplitude, gravity_.frequency, t, factor_); }
    void act(std::size_t k) override { body_.act(mass_ * factor_[k] * gravity_.g, Vec3::Zero(), k); }

  private:
    Gravity gravity_;
    Real mass_;
    BodySeries& body_;
    Scalars factor_;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
