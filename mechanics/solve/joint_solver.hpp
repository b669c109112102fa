// SPDX-License-Identifier: BSD-3-Clause
//
// The index-1 system of bodies with joints of any kind, in body axes and thus the same for every formulation.
// A solve is
//   free motion      a = (A, omega') = M^{-1} (forces, gyroscopic torque),  A = R^T x''
//   joint residual   rho = C a + bias          C:  mechanics/solve/constraint_matrix.hpp
//   complement       S lambda = rho            S = C M^{-1} C^T:  mechanics/solve/complement.hpp
//   reaction         a -= M^{-1} C^T lambda
// Rows that depend on others in the initial configuration are left out (mechanics/solve/row_selection.hpp); as a
// mechanism turns, others may be the better ones to leave out. They are
// watched: where one is violated by the accelerations, or where the rows kept lose rank (and no other choice of as many
// rows is better), it returns singular_kkt, and also where a pivot is doubtful and the rows kept are not met after
// one step of iterative refinement. What a row is measured by is in mechanics/solve/row_terms.hpp. What is reported are
// the multipliers of least norm (mechanics/solve/least_norm.hpp). Masses are taken in the unit of
// mechanics/model/scales.hpp.
#pragma once

#include <utility>

#include "mechanics/solve/complement.hpp"
#include "mechanics/solve/least_norm.hpp"
#include "mechanics/solve/row_selection.hpp"
#include "mechanics/solve/row_terms.hpp"
#include "mechanics/system.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

class JointSolver {
  public:
    JointSolver(const Model& model, SolverChoice choice);

    std::vector<BodyNode>& nodes() { return nodes_; }
    /// From the motions of the nodes to their accelerations under gravity, forces and joints; with the turns of the
    /// torsion springs and their labels.
    Status accelerate(const Real& t, const Turns& turns, const Real* labels);
    /// Rows and factors at the motions of the nodes.
    Status prepare(const Real& t);
    /// After preparation, with free accelerations in the nodes: makes C a = c, c in the order of the joints.
    Status constrain(const VecX& c);
    /// The multipliers of the last solve over the mass unit, in the order of the joints: those of least norm, or zero
    /// for the dropped rows.
    const VecX& multipliers();
    const VecX& basic_multipliers() const { return lambda_; }
    /// After preparation: turns multipliers into those of least norm.
    void minimise_norm(VecX& lambda);
    /// Smallest pivot of the last factors, relative to its diagonal entry.
    const Real& pivot() const { return pivot_; }
    /// The smallest of all factors since the last call; 1 without any.
    Real least_pivot() { return std::exchange(least_pivot_, Real(1)); }
    /// After multipliers(): whether the null space of C^T does not touch a row, so that its multiplier is unique.
    bool is_unique(Eigen::Index row) const { return selection_.is_complete() || least_norm_.is_unique(row); }
    /// kg; forces of `mobility` and `multipliers` are divided by it.
    const Real& mass_unit() const { return mass_unit_; }
    /// Where row k of a joint stands in that order.
    Eigen::Index at(std::size_t joint, int k) const { return C_.at(joint, k); }
    int rows(std::size_t joint) const { return C_.rows(joint); }
    ConstraintRank constraint_rank() const;
    const std::string& singularity() const { return singularity_; }
    /// After an iteration has failed near the prepared configuration: the row that is closest to depending on others,
    /// if any is close.
    std::string weakness() const;

  private:
    static std::vector<BodyNode> bodies_at_start(const Model& model, const Real& mass_unit);
    static RowSelection select_rows(const Model& model, ConstraintMatrix& C, const std::vector<BodyNode>& bodies);

    void move_freely(const Real& t, const Turns& turns, const Real* labels);
    /// Factors, choosing other rows if pivots are doubtful.
    Status choose_and_factor();
    Status choose_again();
    /// Other rows in place of those kept, if they are far more independent.
    void choose_better();
    /// a -= M^{-1} C^T lambda with C a + bias = 0; on entry residual_ holds the bias.
    Status react(bool watch);
    /// residual_ = bias + C a, zero in dropped rows unless they are requested.
    void evaluate_residual(bool all_rows);
    /// One step of iterative refinement, and whether the kept rows are satisfied.
    bool refine();
    bool dropped_rows_hold();
    /// Whether residual_ is at most a share of the terms of its mechanism in all kept, or all dropped, rows. If not,
    /// singularity_ is `what` and the rows.
    bool hold(bool those_kept, const Real& share, const char* what);

    const Model& model_;
    Real mass_unit_;
    std::vector<BodyNode> nodes_;
    ConstraintMatrix C_;
    RowSelection selection_;
    Complement S_;
    RowTerms terms_;
    LeastNorm least_norm_;
    bool doubtful_ = false;  // the last factors have small pivots
    Real pivot_ = 1, least_pivot_ = 1;
    Real best_pivot_ = 0;  // since rows were last compared
    VecX residual_, lambda_, correction_, bias_;
    std::string singularity_;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
