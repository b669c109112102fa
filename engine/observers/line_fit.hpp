// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lie/real.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Least-squares line through (t, y), kept by running means (one pass, no cancellation).
class LineFit {
  public:
    void add(const Real& t, const Real& y) {
        ++points_;
        const Real dt = t - t_, dy = y - y_;
        t_ += dt / Real(points_);
        y_ += dy / Real(points_);
        t_t_ += dt * (t - t_);
        t_y_ += dt * (y - y_);
        y_y_ += dy * (y - y_);
    }
    Real slope() const { return t_t_ > 0 ? t_y_ / t_t_ : Real(0); }
    /// Standard error of the slope; needs three points.
    Real slope_error() const {
        const Real rest = y_y_ - slope() * t_y_;
        return sqrt(max(rest, Real(0)) / Real(points_ - 2) / t_t_);
    }
    long points() const { return points_; }

  private:
    long points_ = 0;
    Real t_ = 0, y_ = 0, t_t_ = 0, t_y_ = 0, y_y_ = 0;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
