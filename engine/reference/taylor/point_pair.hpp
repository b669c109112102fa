// SPDX-License-Identifier: BSD-3-Clause
//
// A point of one body and a point of another as power series in time: with b the place of a point from the mass centre
// of its body,
//   d = x_second + b_second - x_first - b_first,   l = |d|.
#pragma once

#include "engine/reference/taylor/force_series.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

class PointPair {
  public:
    /// Of a force with the members first, second (bodies), r_first, r_second (points in body axes, m).
    template <class Force>
    PointPair(const Force& force, const BodyAt& at)
        : first_(at(force.first)),
          second_(at(force.second)),
          arm_first_(first_, force.r_first),
          arm_second_(second_, force.r_second),
          d_(kreisel::vectors(first_)),
          square_(kreisel::scalars(first_)),
          length_(square_) {}

    /// Coefficient i of d.
    void update(std::size_t i) {
        arm_first_.update(i), arm_second_.update(i);
        d_[i] = second_.x[i] + arm_second_[i] - first_.x[i] - arm_first_[i];
    }
    /// Coefficient i of l^2 and l, from d; the points must be apart.
    void measure(std::size_t i) {
        square_[i] = dot(d_, d_, i);
        length_[i] = square_root(square_, length_, i);
    }
    const Vectors& d() const { return d_; }
    const Scalars& square() const { return square_; }
    const Scalars& length() const { return length_; }

    /// Coefficient k of a force on the first point, and of the opposite one on the second.
    void pull(const Vectors& force, std::size_t k) {
        first_.act(force[k], cross(arm_first_.series(), force, k), k);
        second_.act(-force[k], -cross(arm_second_.series(), force, k), k);
    }

    /// As many coefficients as the bodies have.
    Vectors vectors() const { return kreisel::vectors(first_); }
    Scalars scalars() const { return kreisel::scalars(first_); }

  private:
    BodySeries &first_, &second_;
    Attached arm_first_, arm_second_;
    Vectors d_;
    Scalars square_, length_;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
