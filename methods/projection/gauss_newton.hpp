// SPDX-License-Identifier: BSD-3-Clause
//
// Projections by group updates [eich1993], [terzenaudet2008]: positions by Gauss-Newton, then velocities. Which of the
// corrections that meet the linearised rows is taken is that of a Correction; the least in the metric of the mass
// matrix gives the nearest state.
#pragma once

#include <memory>
#include <vector>

#include "methods/contract/projection.hpp"
#include "methods/projection/correction.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

struct ProjectedLevels {
    bool positions = false, velocities = false;
};

class GaussNewtonProjection final : public Projection {
  public:
    /// `once`: a single correction of positions, which leaves them off by the square of what they were off.
    GaussNewtonProjection(System& system, ProjectedLevels levels, bool once, std::unique_ptr<Correction> correction);

    void start() override { correction_->start(); }
    Status project(const Real& t, Real* y) override;

  private:
    /// q <- q exp(delta) until each row of Phi is at round-off of its own terms; projection_failed if that is not
    /// reached.
    Status project_position(const Real& t, Real* y);
    /// v <- v + delta with C v + b = 0; linear, so one solve.
    Status project_velocity(const Real& t, Real* y);
    Status solve(const Real& t, const Real* q);
    Real turn_residual();
    bool stands_still() const;

    System& system_;
    ProjectedLevels levels_;
    bool once_;
    std::unique_ptr<Correction> correction_;
    std::vector<Real> residual_, terms_, scale_, delta_;
};

/// The option `iterations` of projections that act on positions: converged or one.
OptionDescription iterations_option();
bool is_once(const OptionValues& options);

/// The least corrections in the metric that the option `weight` names: mass or identity.
std::vector<OptionDescription> least_projection_options(ProjectedLevels levels);
MakeProjection least_projection(ProjectedLevels levels);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
