// SPDX-License-Identifier: BSD-3-Clause
//
// What the residuals of C v' = xi are compared with: the sizes of the accelerations that meet in a row and in the rest
// of its mechanism, each relative to the scale of its row.
#pragma once

#include "mechanics/solve/constraint_matrix.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

class RowTerms {
  public:
    RowTerms(const Model& model, const ConstraintMatrix& C);

    const VecX& scale() const { return scale_; }  ///< of each row (System::row_scale)
    void clear() { sizes_.setZero(); }
    /// Adds the sizes of the parts of C a.
    void add_accelerations(const ConstraintMatrix& C, const std::vector<BodyNode>& bodies) { add(C, bodies, false); }
    /// The same, and those of the bias with its centripetal parts.
    void add_all(const ConstraintMatrix& C, const std::vector<BodyNode>& bodies, const VecX& bias) {
        add(C, bodies, true);
        sizes_ += bias.cwiseAbs();
    }
    /// After adding: the largest in each mechanism, for its joints.
    void compare(const ConstraintMatrix& C, const std::vector<BodyNode>& bodies);
    /// Whether a residual in a row of a joint is above a share of what was compared.
    bool is_beyond(const Real& residual, const Real& share, std::size_t joint, Eigen::Index row) const {
        return abs(residual) > share * scale_[row] * largest_[island_[joint]];
    }

  private:
    void add(const ConstraintMatrix& C, const std::vector<BodyNode>& bodies, bool spin);

    std::vector<std::size_t> island_;  // of each joint
    std::vector<Real> largest_;        // by island
    VecX sizes_, scale_;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
