// SPDX-License-Identifier: BSD-3-Clause
//
// Joint forces of a run at one instant, as reported: the multipliers, row by row, and the reaction of each
// joint. Where rows are redundant, both are those of least norm, with a flag for those that are still unique.
#pragma once

#include <string>
#include <vector>

#include "engine/engine.hpp"
#include "mechanics/parts/driven_joints.hpp"
#include "mechanics/system.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

class JointForces {
  public:
    JointForces(System& system, const Model& model);
    /// At (t, y), from the multipliers of a method or, where these are null, of the index-1 form; false where that
    /// cannot be solved.
    bool find(const Real& t, const Real* y, const Real* own);
    /// Of the last find that succeeded.
    const std::vector<Real>& multipliers() const { return multipliers_; }
    /// Columns of a trajectory and their values: multipliers where they are unique, and all reactions, with what keeps
    /// prescribed coordinates; where rows are redundant, beside each reaction whether it is unique (1) or of least norm
    /// (0).
    std::vector<Column> columns() const;
    void append_values(bool found, std::vector<std::string>& row) const;
    /// Names of the multipliers and the reactions.
    void report(ReportedState& state) const;
    long evaluations() const { return evaluations_; }

  private:
    /// Calls f(name, unit, value) for what keeps the prescribed coordinates of a joint.
    template <class F>
    void each_drive(std::size_t joint, F f) const {
        if (drives_[joint].shift) f("force", "N", reactions_[joint].driving_force);
        if (drives_[joint].turn) f("torque", "N m", reactions_[joint].driving_torque);
    }
    bool is_unique(std::size_t row) const { return !redundant_ || system_.is_unique(static_cast<int>(row)); }
    std::vector<bool> unique_joints() const;

    System& system_;
    std::vector<ConstraintRow> rows_;
    std::vector<std::string> joints_;
    bool redundant_;
    std::vector<Real> multipliers_, dv_, scratch_;
    std::vector<JointReaction> reactions_;
    std::vector<Drive> drives_;  // of each joint
    long evaluations_ = 0;
};

/// |a - b| of multipliers that are forces (N) and of those that are torques (N m), of the rows of a model.
struct MultiplierDistance {
    Real force = 0, torque = 0;
};
MultiplierDistance multiplier_distance(const std::vector<ConstraintRow>& rows, const std::vector<Real>& a,
                                       const std::vector<Real>& b);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
