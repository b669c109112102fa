// SPDX-License-Identifier: BSD-3-Clause
//
// Beside a pose in which the constraints lose rank, what a state is off its constraints decides where it goes from
// there: with pivots p times those at the start, a residual r of a row stands for a distance r / sqrt(p) from the
// constraints. A run that does not project then moves on in some way, and all numbers look sound. Only closed loops
// have such poses.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "mechanics/solve/pivot_record.hpp"
#include "mechanics/system.hpp"
#include "methods/contract/projection.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// A projection, and after it the question whether the state is known well enough to go on.
class SingularPassage final : public Projection {
  public:
    /// Whether a model has closed loops.
    static bool is_possible(const Model& model);

    /// Of a system of this model. Sizes its work space; `project` allocates nothing but its reason.
    SingularPassage(System& system, const Model& model, std::unique_ptr<Projection> projection);

    /// The status of the projection; if that is ok, singular_kkt where the least pivot since the last call is below
    /// 1/1000 of that of the first and the distance is above 1e-6, of positions relative to System::row_scale, of
    /// velocities to the rate of the motion too.
    Status project(const Real& t, Real* y) override;
    void start() override { projection_->start(); }
    void retract() override { projection_->retract(); }
    /// After such a singular_kkt: which joint, and what would help; else empty.
    const std::string& reason() const { return reason_; }

  private:
    Real rate(const Real* y);
    /// The largest |residual_| over scale_ and `unit`, and its row.
    std::pair<Real, std::size_t> worst(const Real& unit) const;

    Status check(const Real& t, const Real* y);

    System& system_;
    PivotRecord* pivots_;  // null: all solves are well conditioned
    std::unique_ptr<Projection> projection_;
    std::vector<std::string> joints_;  // by joint
    Real extent_;
    std::vector<Real> residual_, scale_;
    std::vector<BodyState> states_;
    Real first_ = 0;  // least pivot of the first step
    std::string reason_;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
