// SPDX-License-Identifier: BSD-3-Clause
//
// A sparse symmetric positive definite matrix of small dense blocks, one row of blocks per joint, and three ways to
// solve with it. Vectors hold their entries joint by joint.
#pragma once

#include <memory>
#include <vector>

#include "lie/linear.hpp"
#include "mechanics/blocks/solver_choice.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

using Mat6 = Eigen::Matrix<Real, 6, 6>;

/// The blocks of joint pairs that share a body; of each 6x6 array the top left rows[i] x rows[k] entries count.
struct BlockMatrix {
    struct Entry {
        int row, col;  // row > col
    };
    std::vector<int> rows, offset;  ///< of each joint
    int size = 0;                   ///< sum of rows
    std::vector<Mat6> diagonal;
    std::vector<Entry> entries;
    std::vector<Mat6> lower;  ///< block (row, col) of each entry

    void add_joint(int count);
};

class BlockSolver {
  public:
    virtual ~BlockSolver() = default;
    /// Factors S and returns the smallest pivot relative to the diagonal entry it came from: 0 or less, or NaN, where S
    /// is not positive definite; then solve() may not be called.
    virtual Real factor(const BlockMatrix& S) = 0;
    /// Solves S x = b in place.
    virtual void solve(VecX& b) = 0;
};

/// Dense Cholesky factors: for few rows.
std::unique_ptr<BlockSolver> dense_solver(const BlockMatrix& pattern);
/// Block LDL^T along the joint graph, in an order without fill for chains and trees.
std::unique_ptr<BlockSolver> graph_solver(const BlockMatrix& pattern);
/// Scalar sparse LDL^T in an approximate minimum degree order: for many loops.
std::unique_ptr<BlockSolver> sparse_solver(const BlockMatrix& pattern);

std::unique_ptr<BlockSolver> make_solver(const BlockMatrix& pattern, SolverChoice choice);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
