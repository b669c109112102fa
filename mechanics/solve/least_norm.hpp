// SPDX-License-Identifier: BSD-3-Clause
//
// Multipliers of least norm, each row divided by its scale, where rows depend on others:
//   lambda -= P lambda,   P = U U^T the projector onto the null vectors of C^T.
// These are (S^{-1} S_k, -1), one for each dropped row k, with S_k the column of C M^{-1} C^T.
#pragma once

#include "mechanics/solve/complement.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

class LeastNorm {
  public:
    /// For the factors of S at C.
    void minimise(const ConstraintMatrix& C, const RowSelection& selection, const VecX& scale, Complement& S,
                  VecX& lambda);
    /// After that: whether the null space of C^T does not touch a row, so that its multiplier is unique.
    bool is_unique(Eigen::Index row) const { return share_[row] <= touched; }

  private:
    /// A null vector is accurate to about 1e-9, by which a start may violate its joints; under drift to less.
    static inline const Real touched = Real(1) / 1000000;

    VecX share_;  // of each row in the null space, the norm of its row of U: between 0 and 1
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
