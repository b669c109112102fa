// SPDX-License-Identifier: BSD-3-Clause
//
// Mass-weighted projections by group updates [eich1993], [terzenaudet2008]: each correction is the solution of
// [M C^T; C 0] [delta; .] = [0; -residual], the least one in the metric of the mass matrix.
#pragma once

#include <vector>

#include "methods/contract/projection.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

class GaussNewtonProjection : public Projection {
  public:
    explicit GaussNewtonProjection(System& system);

  protected:
    /// q <- q exp(delta) until each row of Phi is at round-off of its own terms; projection_failed if that is not
    /// reached.
    Status project_position(const Real& t, Real* y);
    /// v <- v + delta with C v + b = 0; linear, so one solve.
    Status project_velocity(const Real& t, Real* y);

  private:
    Status solve(const Real& t, const Real* q);
    Real turn_residual();
    bool stands_still() const;

    System& system_;
    std::vector<Real> residual_, terms_, scale_, delta_;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
