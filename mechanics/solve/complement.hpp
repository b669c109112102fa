// SPDX-License-Identifier: BSD-3-Clause
//
// The Schur complement S = C M^{-1} C^T of the mass matrix in the KKT matrix, reduced to the rows that are kept: the
// others are unit rows, so that with a zero right-hand side their multiplier is zero.
#pragma once

#include <memory>

#include "mechanics/blocks/solvers.hpp"
#include "mechanics/solve/constraint_matrix.hpp"
#include "mechanics/solve/row_selection.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

class Complement {
  public:
    /// S has a block for each pair of joints that share a body.
    Complement(const ConstraintMatrix& C, SolverChoice choice);

    /// Assembles and factors S for the mobilities of C. Returns the smallest pivot relative to its diagonal entry;
    /// where that is not positive, `solve` may not be called.
    Real factor(const ConstraintMatrix& C, const RowSelection& selection);
    /// S x = b, in place.
    void solve(VecX& b) { solver_->solve(b); }

  private:
    /// Two ends on one body, of joints row >= col; the block is that of an entry, or a diagonal one.
    struct EndPair {
        std::size_t row_end, col_end, block;
        bool diagonal;
    };
    void connect(const ConstraintMatrix& C);
    void assemble(const ConstraintMatrix& C);
    void drop_rows(const ConstraintMatrix& C, const RowSelection& selection);

    std::vector<EndPair> pairs_;
    BlockMatrix matrix_;
    std::unique_ptr<BlockSolver> solver_;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
