// SPDX-License-Identifier: BSD-3-Clause
//
// Implicit stages in TG, where velocities are additive (methods/implicit/stages/implicit_stages.hpp).
#pragma once

#include <vector>

#include "methods/implicit/stages/implicit_stages.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

class TangentStages final : public ImplicitStages {
  public:
    TangentStages(System& system, StageCoefficients coefficients, StageCentre centre);

  private:
    Status residual(const Real* turned, Real* r) override;
    Status slope_at_start(Real* rate, Real* f) override;
    void accept(Real* y) override;

    void find_centre();
    void place(Eigen::Index i);
    Status renew_slopes(Real* of_positions);
    Status stage(Eigen::Index i, Real* of_position, Real* of_velocity);

    MatX renewed_;             // a column a stage
    VecX half_, u_, stage_v_;  // half_: theta/2, or 0 around q
    std::vector<Real> centre_, stage_q_;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
