// SPDX-License-Identifier: BSD-3-Clause
//
// The group by which the states of a recorded run move, with dense matrices: TG, whose velocities are additive, or as
// SO3-LiePoisson T*SO(3), where states are (R, J_O omega) and slopes (omega, torque).
#pragma once

#include "tests/judges/steps/recorded_steps.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

class DenseStates {
  public:
    /// `run` outlives this.
    explicit DenseStates(RecordedRun& run);

    Eigen::Index dim() const { return 2 * n_; }
    /// u with next = y exp(u).
    VecX increment(const RecordedState& y, const RecordedState& next) const;
    /// The left-trivialised dexp^{-1}_{-u}(z).
    VecX pulled_back(const VecX& u, const VecX& z) const;
    /// y exp(u), at the time t.
    RecordedState moved(const RecordedState& y, const VecX& u, const Real& t) const;
    /// F(t, y).
    VecX slope(const RecordedState& y) const;

  private:
    MatX matrix(const RecordedState& y) const;
    VecX slope_on_cotangent(const RecordedState& y) const;

    RecordedRun& run_;
    Eigen::Index n_;
    bool acted_;
    MatrixGroup group_;  // T*SO(3)
    Mat3 J_O_;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
