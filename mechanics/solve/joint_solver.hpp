// SPDX-License-Identifier: BSD-3-Clause
//
// The index-1 system of bodies with joints of any kind, in body axes and thus the same for every formulation. With the
// wrenches W of the rows on each body (columns of JointRows::first and second), a solve is
//   free motion      a = (A, omega') = M^{-1} (forces, gyroscopic torque),  A = R^T x''
//   joint residual   rho = sum W^T a + bias                    over the bodies of each joint
//   complement       S lambda = rho,  S = C M^{-1} C^T         (mechanics/solve/block_matrix.hpp)
//   reaction         a - M^{-1} W lambda
// Rows that depend on others in the initial configuration are left out: unit rows of S with zero right-hand side, so
// that their multiplier is zero. They are watched: where one is violated by the accelerations, or where the rows kept
// lose rank (and no other choice of as many rows is better), the answer is singular_kkt. So it is where a pivot is
// doubtful and the rows kept are not met after one step of iterative refinement. A row is measured by the accelerations
// that meet in it and in the rest of its mechanism, each relative to the scale of its row. What is reported are the
// multipliers of least norm, found through the null vectors of C^T, one for each row left out. Masses are taken in the
// unit of mechanics/model/scales.hpp.
#pragma once

#include <utility>

#include "mechanics/joints/joint_rows.hpp"
#include "mechanics/solve/block_matrix.hpp"
#include "mechanics/solve/rank.hpp"
#include "mechanics/system.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// A body with what one evaluation computes for it: a = (A, omega'). Masses, forces and torques are in mass units.
struct BodyNode {
    Real inverse_mass;
    Mat3 J, J_inverse;
    Motion motion;
    Vec6 a = Vec6::Zero();
    /// M^{-1} (force, torque).
    Vec6 mobility(const Vec6& wrench) const {
        Vec6 acceleration;
        acceleration << inverse_mass * wrench.head<3>(), J_inverse * wrench.tail<3>();
        return acceleration;
    }
};

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
    bool is_unique(Eigen::Index row) const { return complete_ || share_[row] <= touched; }
    /// kg; forces of `mobility` and `multipliers` are divided by it.
    const Real& mass_unit() const { return mass_unit_; }
    /// Where row k of a joint stands in that order.
    Eigen::Index at(std::size_t joint, int k) const { return matrix_.offset[joint] + k; }
    int rows(std::size_t joint) const { return matrix_.rows[joint]; }
    ConstraintRank constraint_rank() const;
    const std::string& singularity() const { return singularity_; }
    /// After an iteration has failed near the prepared configuration: the row that is closest to depending on others,
    /// if any is close.
    std::string weakness() const;

  private:
    /// A joint on a moving body: W and M^{-1} W.
    struct End {
        std::size_t joint, body;
        const Mat6* W;
        Mat6 mobility = Mat6::Zero();
    };
    /// Two ends on one body, of joints row >= col; the block is that of an entry, or a diagonal one.
    struct EndPair {
        std::size_t row_end, col_end, block;
        bool diagonal;
    };

    /// A null vector is accurate to about 1e-9, by which a start may violate its joints; under drift to less.
    static inline const Real touched = Real(1) / 1000000;

    void connect();
    void choose_rows_at_start();
    void evaluate_rows(const Real& t);
    void assemble();
    /// Returns the smallest relative pivot.
    Real factor();
    Status choose_again();
    /// a -= M^{-1} C^T lambda with C a + bias = 0; on entry residual_ holds the bias.
    Status react(bool watch);
    /// Factors, choosing other rows if pivots are doubtful.
    Status choose_and_factor();
    /// residual_ = bias + C a, zero in dropped rows unless they are requested.
    void evaluate_residual(bool all_rows);
    /// a -= M^{-1} C^T lambda.
    void apply(const VecX& lambda);
    /// Adds the sizes of what meets in each row: accelerations, and on demand the bias with its centripetal parts.
    void add_terms(bool bias);
    /// The largest of sizes_ over scale_ in each mechanism, for its joints.
    void compare_terms();
    /// One step of iterative refinement, and whether the kept rows are satisfied.
    bool refine();
    bool left_out_rows_hold();
    /// Whether residual_ is at most a share of the terms of its mechanism in all kept, or all dropped, rows. If not,
    /// singularity_ is `what` and the rows.
    bool hold(bool those_kept, const Real& share, const char* what);
    /// C^T of all rows, each wrench on a body as weigh(body, wrench) has it.
    template <class Weigh>
    MatX transpose(Weigh weigh) const;
    /// Independent of units, masses and place: torques over a length of the body.
    MatX geometric_transpose() const;
    Real condition() const;
    std::string name_row(std::size_t joint, int k) const;
    std::string name_rows(const std::vector<bool>& rows, bool which) const;
    bool kept(Eigen::Index row) const { return choice_.independent[static_cast<std::size_t>(row)]; }

    const Model& model_;
    std::vector<BodyNode> nodes_;
    std::vector<JointRows> rows_;
    std::vector<End> ends_;
    std::vector<EndPair> pairs_;
    BlockMatrix matrix_;
    std::unique_ptr<BlockSolver> solver_;
    Real mass_unit_;
    RowChoice choice_;
    std::optional<Real> condition_;  // once requested
    bool complete_ = true;           // no row is dropped
    bool doubtful_ = false;          // the last factors have small pivots
    Real pivot_ = 1, least_pivot_ = 1;
    std::vector<Real> length_;         // of each body
    std::vector<std::size_t> island_;  // of each joint
    std::vector<Real> largest_;        // by island
    VecX residual_, lambda_, correction_, sizes_, bias_, scale_;
    VecX share_;  // of each row in the null space of C^T, between 0 and 1
    std::string singularity_;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
