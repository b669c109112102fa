// SPDX-License-Identifier: BSD-3-Clause
//
// Which rows of C are kept in a solve: as many as are independent in the initial configuration. Which ones can change;
// independence is decided by geometry only (mechanics/solve/rank.hpp).
#pragma once

#include <optional>

#include "mechanics/solve/constraint_matrix.hpp"
#include "mechanics/solve/rank.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

class RowSelection {
  public:
    /// C and the bodies are evaluated at the start of the model.
    RowSelection(const Model& model, const ConstraintMatrix& C, const std::vector<BodyNode>& bodies);

    bool is_kept(Eigen::Index row) const { return choice_.independent[static_cast<std::size_t>(row)]; }
    bool is_complete() const { return complete_; }  ///< no row is dropped
    int rank() const { return choice_.rank; }
    /// Ratio of the extreme pivots of M^{-1/2} C^T at the start, where it was computed.
    const std::optional<Real>& condition() const { return condition_; }

    /// The most independent rows of C as it stands, at most `rank` of them; nothing where C is not finite.
    std::optional<RowChoice> best(const ConstraintMatrix& C, int rank) const;
    void set(const RowChoice& choice);

  private:
    MatX geometric_transpose(const ConstraintMatrix& C) const;

    std::vector<Real> length_;  // of each body
    RowChoice choice_;
    std::optional<Real> condition_;
    bool complete_ = true;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
