// SPDX-License-Identifier: BSD-3-Clause
//
// Solving with a BlockMatrix. There are three ways, each in a file of its own, with the same results.
#pragma once

#include <memory>

#include "mechanics/blocks/block_matrix.hpp"
#include "mechanics/blocks/solver_choice.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

class BlockSolver {
  public:
    virtual ~BlockSolver() = default;
    /// Factors S and returns the smallest pivot relative to the diagonal entry it came from: 0 or less, or NaN, where S
    /// is not positive definite; then solve() may not be called.
    virtual Real factor(const BlockMatrix& S) = 0;
    /// Solves S x = b in place.
    virtual void solve(VecX& b) = 0;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
