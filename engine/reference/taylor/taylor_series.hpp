// SPDX-License-Identifier: BSD-3-Clause
//
// The Taylor series in time of a model's motion, straight from its bodies, joints and forces (taylor_bodies.hpp,
// taylor_joints.hpp, force_series.hpp). Products of series are Cauchy products. Coefficient by coefficient,
//   free motion   coefficients k of v' and omega' from the forces and from lambda_0 ... lambda_{k-1},
//   residual      Phi_{k+2} of every joint row, from x_{k+2} and R_{k+2} of that motion,
//   multipliers   S lambda_k = (k+1) (k+2) Phi_{k+2},  S = C M^{-1} C^T at the expansion point,
//   reaction      v', omega' -= M^{-1} C^T lambda_k.
// S is the same for every k: it is factored once [hairer1993, Sec. I.8], in taylor_complement.hpp. Rows may be
// dependent: multipliers are those of least norm, each row divided by its scale. Steps end where the last terms sink
// into round-off [jorbazou2005].
#pragma once

#include <memory>
#include <vector>

#include "engine/reference/taylor/force_series.hpp"
#include "engine/reference/taylor/taylor_complement.hpp"
#include "engine/reference/taylor/taylor_joints.hpp"
#include "lie/status.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// One object per thread: it owns its work space.
class TaylorSeries {
  public:
    /// Throws std::invalid_argument for an order below 2.
    TaylorSeries(const Model& model, int order);
    TaylorSeries(const TaylorSeries&) = delete;
    TaylorSeries& operator=(const TaylorSeries&) = delete;

    /// The series of the motion that passes through `states` at time t (s). Returns singular_kkt if the rank
    /// of the constraints is not that of the first expansion, or if dependent rows contradict each
    /// other; turn_lost if the axes of a torsion spring have parted so far that turns are undefined.
    Status expand(const Real& t, const std::vector<BodyState>& states);
    /// Before the next expansion, if it continues this motion a time s after the last one: full turns are then kept.
    void move_on(const Real& s);

    /// The largest s = limit, 7/8 limit, ... for which the last two terms of x, R, v and omega (each over all bodies)
    /// are below round-off of their largest terms; negative for a negative limit.
    Real reach(const Real& limit) const;
    /// Whether the axes of a torsion spring have parted a time s after the expansion, so that turns are undefined.
    bool has_parted(const Real& s) const;
    /// The states at a time s after that of the expansion; |s| within reach.
    std::vector<BodyState> states(const Real& s) const;
    /// A time s after that of the expansion, |s| within reach: lambda (N, or N m where rows compare directions), joints
    /// in the order of the model; rows without a position level after all others.
    std::vector<Real> multipliers(const Real& s = 0) const;

  private:
    std::vector<JointSeries> joints_of(const Model& model);
    void add_forces(const Model& model);
    Status start(const Real& t, const std::vector<BodyState>& states);
    BodySeries& at(int body) { return body == ground ? bodies_.back() : bodies_[static_cast<std::size_t>(body)]; }
    bool is_finite() const;
    /// Free motion to coefficient k of the accelerations.
    void move_freely(std::size_t k);
    /// Coefficient k of the multipliers, and the reaction.
    Status constrain(std::size_t k);
    /// (k+1) (k+2) Phi_{k+2} of every row over its scale.
    VecX residual(std::size_t k) const;
    void react(const VecX& lambda, std::size_t k);

    std::size_t order_;
    std::vector<BodySeries> bodies_;  // the last is the ground
    std::vector<std::unique_ptr<ForceSeries>> forces_;
    std::vector<JointSeries> joints_;
    TaylorComplement complement_;
    std::vector<JointSeries::Wrench> reaction_;  // on each body
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
