// SPDX-License-Identifier: BSD-3-Clause
//
// What round-off in the velocities of a step is relative to.
#pragma once

#include <vector>

#include "mechanics/system.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Size s of a velocity: the largest entry of v, or what the forces alone would make of rest within h, |h| |Q| / m,
/// if that is more; 1 where both vanish. m is the largest diagonal entry of M. Forces count because at equilibrium v and v'
/// are round-off themselves, of terms that cancel.
class VelocityScale {
  public:
    explicit VelocityScale(System& system);
    void measure(const Real& t, const Real& h, const Real* y);
    const Real& velocity() const { return velocity_; }  ///< s
    Real impulse() const { return mass_ * velocity_; }  ///< m s

  private:
    System& system_;
    Real velocity_ = 1, mass_ = 1;
    std::vector<Real> blocks_, applied_, gyroscopic_;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
