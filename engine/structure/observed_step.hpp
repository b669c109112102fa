// SPDX-License-Identifier: BSD-3-Clause
//
// A step of a method from one state, as a map of states: what its geometry is measured from.
#pragma once

#include <functional>
#include <limits>
#include <string>

#include "mechanics/system.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// y(t) -> y(t + h) in place, as if no step had been made before. Any status but ok leaves nothing of use in y.
using Step = std::function<Status(const Real& t, const Real& h, Real* y)>;

struct ObservedStep {
    System& system;
    const Step& step;
    Real length;  ///< of the mechanism, m
    Real t, h;    ///< s
    const Real* y;
};

/// What was measured of a step. A value is meaningful where it is far above its uncertainty, which truncation and
/// round-off of differences leave; both are NaN where nothing could be measured, and `why_not` says why.
struct StepDefect {
    Real value = std::numeric_limits<Real>::quiet_NaN(), uncertainty = value;
    std::string why_not = {};
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
