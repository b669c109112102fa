// SPDX-License-Identifier: BSD-3-Clause
//
// What round-off in the velocities of a step is relative to, free of units: the mass metric makes metres per second and
// radians per second comparable, and sizes of single coordinates follow from it.
#pragma once

#include <vector>

#include "mechanics/system.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Size s of a motion, a root of energy: the largest of sqrt(M_ii) |v_i|, and of |h Q_i| / sqrt(M_ii), what the forces
/// alone would make of rest within h; 1 where all vanish. Forces count because at equilibrium v and v' are round-off
/// themselves, of terms that cancel.
class MotionScale {
  public:
    explicit MotionScale(System& system);
    void measure(const Real& t, const Real& h, const Real* y);
    /// s / sqrt(M_ii).
    const std::vector<Real>& velocities() const { return velocities_; }
    /// Size of the impulse h lambda_k of row k of C (m x n): s / sqrt(S_kk), S_kk = sum_i C_ki^2 / M_ii.
    Real impulse(const MatX& C, Eigen::Index row) const;

  private:
    System& system_;
    Real size_ = 1;
    std::vector<Real> root_mass_, velocities_, blocks_, applied_, gyroscopic_;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
