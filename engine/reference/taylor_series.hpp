// SPDX-License-Identifier: BSD-3-Clause
//
// The Taylor series in time of a model's motion, straight from its bodies, joints and forces (taylor_bodies.hpp,
// taylor_joints.hpp, taylor_forces.hpp). Products of series are Cauchy products. Coefficient by coefficient,
//   free motion   coefficients k of v' and omega' from the forces and from lambda_0 ... lambda_{k-1},
//   residual      Phi_{k+2} of every joint row, from x_{k+2} and R_{k+2} of that motion,
//   multipliers   S lambda_k = (k+1) (k+2) Phi_{k+2},  S = C M^{-1} C^T at the expansion point,
//   reaction      v', omega' -= M^{-1} C^T lambda_k.
// S is the same for every k: it is factored once [hairer1993, Sec. I.8]. Rows may be dependent, which is decided
// by geometry only, torques on a body divided by a length of it: multipliers are those of least norm, each row divided
// by its scale. Steps end where the last terms sink into round-off
// [jorbazou2005].
#pragma once

#include <Eigen/Cholesky>
#include <memory>
#include <vector>

#include "engine/reference/taylor_forces.hpp"
#include "engine/reference/taylor_joints.hpp"
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
    /// At the time of the expansion: lambda (N, or N m where rows compare directions), joints in the order of the
    /// model; rows without a position level after all others.
    std::vector<Real> multipliers() const;

  private:
    void add_forces(const Model& model);
    BodySeries& at(int body) { return body == ground ? bodies_.back() : bodies_[static_cast<std::size_t>(body)]; }
    void weigh();
    bool decompose();
    Eigen::Index geometric_rank() const;
    /// Smallest pivot of S relative to its diagonal, not positive where there are no factors.
    Real factor();
    /// Sizes of the terms of each row, over its scale (1/s^2).
    VecX terms() const;
    VecX solve(const VecX& residual) const;
    bool contradicts(const VecX& residual) const;
    Status react(std::size_t k);

    std::size_t order_;
    std::vector<BodySeries> bodies_;  // the last is the ground
    std::vector<std::unique_ptr<ForceSeries>> forces_;
    std::vector<JointSeries> joints_;
    struct Row {
        std::size_t joint;
        int row;
        Real scale;
    };
    std::vector<Row> rows_;
    std::vector<Real> lengths_;  // of the bodies: the radius of gyration or the longest arm
    MatX A_;                     // M^{-1/2} C^T, columns divided by the rows' scale, so that S = A^T A
    Eigen::LLT<MatX> cholesky_;
    bool factored_ = false;                      // S by Cholesky's factors; else by
    MatX inverse_;                               // the pseudoinverse of A
    Eigen::Index rank_ = -1;                     // of the first expansion
    std::vector<JointSeries::Wrench> reaction_;  // on each body
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
