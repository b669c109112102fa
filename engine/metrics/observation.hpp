// SPDX-License-Identifier: BSD-3-Clause
//
// A state as metrics and samples see it. What several of them need is computed once.
#pragma once

#include <array>
#include <vector>

#include "mechanics/system.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Phi, C v + b, or C v' - xi.
enum class RowLevel { position, velocity, acceleration };

class Observation {
  public:
    /// Refers to the system.
    explicit Observation(System& system);

    /// From now on the state y = (q, v) at time t (s), which is referred to.
    void move_to(const Real& t, const Real* y);

    System& system() { return system_; }
    const Real& t() const { return t_; }
    const Real* y() const { return y_; }

    const std::vector<BodyState>& bodies();
    const std::vector<SpringAngle>& springs();  ///< of the torsion springs
    MotionState motion();

    /// The constraint rows on a level; rows without a position level are zero there. All are NaN where the
    /// accelerations cannot be solved for.
    const VecX& rows(RowLevel level);
    /// Euclidean norm of those that compare directions, or of those that are lengths.
    Real norm(RowLevel level, bool direction);

    /// Solves of the dynamics so far.
    long evaluations() const { return evaluations_; }

  private:
    struct Rows {
        VecX values;
        bool known = false;
    };
    void read_motion();
    void measure(RowLevel level, VecX& rows);
    void measure_accelerations(VecX& rows);

    System& system_;
    Real t_ = 0;
    const Real* y_ = nullptr;
    std::vector<BodyState> bodies_;
    std::vector<SpringAngle> springs_;
    std::vector<Real> angles_;
    bool motion_known_ = false;
    std::vector<ConstraintRow> kinds_;
    std::array<Rows, 3> rows_;
    VecX xi_, bias_, dv_;
    long evaluations_ = 0;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
