// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "methods/symmetric_projection/projected_step.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// The implicit midpoint rule between the projections; its slope is w = v~+ - v~.
class ProjectedMidpoint final : public ProjectedStep {
  public:
    ProjectedMidpoint(System& system, const MotionScale& scale)
        : ProjectedStep(system, scale, 1), middle_v_(moved_), f_(moved_) {}

    void guess(const VecX& change, Real* slopes) const override;
    Real largest_change() const override { return abs(h_) * scale_.of_velocity(f_.data()); }

  private:
    void place_step(const Real* slopes) override;
    Status step_residual(const Real* slopes, Real* r) override;
    void add_change(const Real* slopes, const Real& sign, VecX& to) const override;
    void add_increment(const Real* slopes, const Real& sign, VecX& to) const override;

    VecX middle_v_, f_;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
