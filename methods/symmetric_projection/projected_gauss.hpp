// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "methods/implicit/stages/implicit_stages.hpp"
#include "methods/symmetric_projection/projected_step.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// A Gauss method in coordinates around the middle of the step, between the projections; its slopes are k_1, k_2, ...,
/// w_1, w_2, ... with w_i = h f_i.
class ProjectedGauss final : public ProjectedStep {
  public:
    ProjectedGauss(System& system, const MotionScale& scale, int stages);

    void guess(const VecX& change, Real* slopes) const override;
    Real largest_change() const override;

  private:
    void place_step(const Real* slopes) override;
    Status step_residual(const Real* slopes, Real* r) override;
    void add_change(const Real* slopes, const Real& sign, VecX& to) const override;
    void add_increment(const Real* slopes, const Real& sign, VecX& to) const override;
    void follow(const VecX& shift, Real* r) const override;

    /// u_ and stage_v_, then r of one stage.
    void place_stage(Eigen::Index i, const Real* slopes);
    Status stage_residual(Eigen::Index i, const Real* slopes, Real* r);
    Eigen::Map<const VecX> k(const Real* slopes, Eigen::Index i) const { return {slopes + i * n_, n_}; }
    Eigen::Map<const VecX> w(const Real* slopes, Eigen::Index i) const { return {slopes + (stages_ + i) * n_, n_}; }

    const StageCoefficients coefficients_;
    const Eigen::Index stages_;
    VecX half_, stage_v_;  // half_: theta/2
    MatX f_;               // a column a stage
    std::vector<Real> stage_q_;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
