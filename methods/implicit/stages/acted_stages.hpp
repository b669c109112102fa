// SPDX-License-Identifier: BSD-3-Clause
//
// Implicit stages where another group than TG acts on states (methods/contract/state_space.hpp): with z = (k, f) in its
// algebra,
//   Y_i = y~ exp(u_i),   u_i = (u^, v^) + h sum_j (a_ij k_j, a^_ij f_j) (- theta/2),
//   (k_i, f_i) = dexp^{-1}_{-u_i}(F(t + c_i h, Y_i)),   y+ = y exp(theta),   theta = (u^, v^) + h sum_j b_j (k_j, f_j),
// around y~ = y or y~ = y exp(theta/2). On T*SO(3), f is the part of a torque: without one every u_i and theta lie in
// so(3), and the momentum in space stays where it is.
#pragma once

#include <vector>

#include "methods/contract/state_space.hpp"
#include "methods/implicit/stages/implicit_stages.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

class ActedStages final : public ImplicitStages {
  public:
    ActedStages(System& system, StageCoefficients coefficients, StageCentre centre);

  private:
    Status residual(const Real* turned, Real* r) override;
    Status slope_at_start(Real* rate, Real* f) override;
    void accept(Real* y) override;

    void find_centre();
    void place(Eigen::Index i);
    void add_offsets();
    /// slope_ = dexp^{-1}_{-u_}(F) at the stage of u_.
    Status slope(const Real& t);

    StateSpace space_;
    MatX renewed_;           // the last k_i, a column a stage
    VecX half_, u_, slope_;  // 2 n; half_: theta/2, or 0 around y
    std::vector<Real> centre_, stage_;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
