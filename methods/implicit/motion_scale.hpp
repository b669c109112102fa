// SPDX-License-Identifier: BSD-3-Clause
//
// What round-off in the velocities of a step is relative to, independent of units: the mass metric makes metres per
// second and radians per second comparable. Weights are taken relative to the first coordinate, so that units of
// length, mass and time which are powers of two change no bit of a comparison.
#pragma once

#include <vector>

#include "mechanics/space_axes.hpp"
#include "mechanics/system.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// w_i = sqrt(M_ii / M_11): all w_i |v_i| have one unit, that of the first velocity coordinate.
class MotionScale {
  public:
    explicit MotionScale(System& system);

    /// The weights at q: computed once. `forget` makes it compute them again.
    void weigh(const Real* q);
    void forget() { known_ = false; }
    const VecX& weights() const { return weights_; }
    const Real& mass_unit() const { return blocks_[0]; }  ///< M_11
    /// w_i v_i turned into space axes for the pose q, where the system knows such: the unknowns of iterations and what
    /// is guessed from earlier steps, all of one unit. A body spinning fast about an axis of symmetry has slow ones,
    /// and its Jacobian is nearly the same step after step. `turned` may be v.
    void to_space(const Real* q, const Real* v, Real* turned) const;
    void from_space(const Real* q, const Real* turned, Real* v) const;
    /// Largest w_i |v_i|.
    Real of_velocity(const Real* v) const;
    /// Largest |p_i| / (w_i M_11), of the velocity that an impulse p causes from rest.
    Real of_impulse(const Real* p) const;
    /// Size of a motion within h: of its velocity, and of the one the forces would cause from rest, because at
    /// equilibrium v and v' are round-off themselves, of terms that cancel.
    Real of_motion(const Real& t, const Real& h, const Real* y);

  private:
    System& system_;
    const SpaceAxes* axes_;
    bool known_ = false;
    VecX weights_, mobility_;  // 1 / (w_i M_11)
    std::vector<Real> blocks_;
    VecX applied_, gyroscopic_;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
