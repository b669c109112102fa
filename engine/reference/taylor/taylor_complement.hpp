// SPDX-License-Identifier: BSD-3-Clause
//
// What determines the multipliers of a Taylor series: S = C M^{-1} C^T at the expansion point, rows divided by their
// scale. With A = M^{-1/2} C^T, S = A^T A. Where rows are independent S has Cholesky factors, otherwise multipliers of
// least norm come from the pseudoinverse of A, at the rank that geometry gives: torques on a body divided by a length
// of it, columns of length 1, no masses.
#pragma once

#include <Eigen/Cholesky>
#include <vector>

#include "engine/reference/taylor/taylor_joints.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

class TaylorComplement {
  public:
    struct Row {
        std::size_t joint;
        int row;  // of the joint
        Real scale;
    };

    /// The series outlive this; the last body is the ground.
    TaylorComplement(const Model& model, const std::vector<BodySeries>& bodies, const std::vector<JointSeries>& joints);

    const std::vector<Row>& rows() const { return rows_; }
    /// At the expansion point of the series. False where the rank is not that of the first time.
    bool factor();
    /// S lambda = residual, both over the scale of their rows.
    VecX solve(const VecX& residual) const;
    /// Whether the residual has a part outside the range of S above round-off and drift of its terms.
    bool contradicts(const VecX& residual) const;

  private:
    /// Calls f(body, wrench) for the two bodies of a row.
    template <class F>
    void each_side(const Row& row, F f) const;
    /// Of a body that moves: its first row in A.
    Eigen::Index place(const BodySeries& body) const { return 6 * (&body - bodies_.data()); }
    void assemble();
    Real factor_complement();
    bool pseudoinvert(Eigen::Index rank);
    Eigen::Index geometric_rank() const;
    /// Sizes of the terms of each row, over its scale (1/s^2).
    VecX terms() const;

    const std::vector<BodySeries>& bodies_;
    const std::vector<JointSeries>& joints_;
    std::vector<Row> rows_;
    std::vector<Real> lengths_;  // of the bodies: the radius of gyration or the longest arm
    MatX A_;
    Eigen::LLT<MatX> cholesky_;
    bool factored_ = false;   // S by Cholesky's factors; else by
    MatX inverse_;            // the pseudoinverse of A
    Eigen::Index rank_ = -1;  // of the first time
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
