// SPDX-License-Identifier: BSD-3-Clause
//
// KKT systems with C at one configuration and C^T at another, as half-explicit and stabilised methods have them,
//   [M C_1^T; C_2 0] [a; lambda] = [f; c],   C_1 = C(t_1, q_1), C_2 = C(t_2, q_2),
// for constant M. S = C_2 M^{-1} C_1^T is not symmetric; the symmetric C_2 M^{-1} C_2^T, for which every model has a
// structured solve, stands in for it, and the residual is solved for again until it is round-off:
//   lambda <- lambda + (C_2 M^{-1} C_2^T)^{-1} (C_2 M^{-1} (f - C_1^T lambda) - c),
// a contraction by the distance of the two configurations. Linear in the bodies of a tree.
#pragma once

#include "mechanics/system.hpp"
#include "methods/implicit/motion_scale.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

struct Configuration {
    Real t;
    const Real* q;
};

class MixedKkt {
  public:
    explicit MixedKkt(System& system);
    /// lambda (m) is the guess on entry; where rows are redundant dropped rows keep theirs. Returns newton_failed if
    /// the configurations are too far apart for the iteration, or the status of a failed solve. Leaves (t_2, q_2)
    /// prepared.
    Status solve(const Configuration& transposed, const Configuration& rows, const Real* f, const Real* c, Real* a,
                 Real* lambda);

  private:
    System& system_;
    MotionScale scale_;
    VecX force_, zero_force_, correction_, residual_, shift_;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
