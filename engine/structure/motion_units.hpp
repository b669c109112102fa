// SPDX-License-Identifier: BSD-3-Clause
//
// Sizes of velocities and variations in units of the motion itself: 1 rad for rotations, the length of the mechanism
// for positions, and these times the rate of the motion for velocities. They depend neither on units nor on the
// formulation.
#pragma once

#include <vector>

#include "mechanics/system.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

class MotionUnits {
  public:
    /// `length` of the mechanism, m; 0 counts as 1. Refers to the system.
    MotionUnits(System& system, const Real& length);

    /// The largest of |omega| and |x'|/length over the bodies, for the velocity coordinates v at q.
    Real operator()(const Real* q, const Real* v);
    /// Rate of the motion (1/s) at the state y(t): the larger of the size of v and the root of that of v', or 1/|h| at
    /// rest without force. Zero where the accelerations cannot be solved for.
    Real rate(const Real& t, const Real& h, const Real* y);
    /// The largest |x|/length, plus 1: what the round-off of positions is relative to.
    Real remoteness(const Real* y);

  private:
    System& system_;
    Real length_;
    std::vector<Real> y_, dv_;
    std::vector<BodyState> bodies_;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
