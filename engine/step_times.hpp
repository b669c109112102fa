// SPDX-License-Identifier: BSD-3-Clause
//
// When the steps of a run begin and end, where they have one size.
#pragma once

#include <cmath>

#include "lie/real.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Times of N steps of one size from t_0 to T. Where t_0 is a whole number k of them after 0, up to round-off, they are
/// those of k + N steps from 0 to T, to the last bit.
class StepTimes {
  public:
    StepTimes() = default;
    StepTimes(const Real& begin, const Real& end, long steps);
    const Real& h() const { return h_; }
    Real at(long step) const;

  private:
    Real begin_ = 0, end_ = 0, origin_ = 0, h_ = 0;
    long before_ = 0, steps_ = 0;
};

inline StepTimes::StepTimes(const Real& begin, const Real& end, long steps) : begin_(begin), end_(end), steps_(steps) {
    using std::floor;
    const Real nearest = floor(begin / (end - begin) * Real(steps) + Real(1) / 2);
    const Real of_all = end / (nearest + Real(steps));
    if (nearest < Real(1L << 52) && abs(of_all * nearest - begin) <= 4 * epsilon * begin) {
        before_ = static_cast<long>(nearest);
        h_ = of_all;
    } else {
        origin_ = begin;
        h_ = (end - begin) / Real(steps);
    }
}

inline Real StepTimes::at(long step) const {
    if (step == 0) return begin_;
    if (step == steps_) return end_;
    return origin_ + h_ * Real(before_ + step);
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
