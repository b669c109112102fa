// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/blocks/dense_solver.hpp"

#include <Eigen/Cholesky>

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

class DenseSolver final : public BlockSolver {
  public:
    explicit DenseSolver(const BlockMatrix& pattern)
        : matrix_(MatX::Zero(pattern.size, pattern.size)), factors_(pattern.size) {}

    Real factor(const BlockMatrix& S) override {
        gather(S);
        factors_.compute(matrix_);  // reads the lower half
        if (factors_.info() != Eigen::Success) return 0;
        return smallest_pivot();
    }
    void solve(VecX& b) override { factors_.solveInPlace(b); }

  private:
    void gather(const BlockMatrix& S) {
        for (std::size_t j = 0; j < S.rows.size(); ++j)
            matrix_.block(S.offset[j], S.offset[j], S.rows[j], S.rows[j]) =
                S.diagonal[j].topLeftCorner(S.rows[j], S.rows[j]);
        for (std::size_t e = 0; e < S.entries.size(); ++e) {
            const std::size_t row = at(S.entries[e].row), col = at(S.entries[e].col);
            matrix_.block(S.offset[row], S.offset[col], S.rows[row], S.rows[col]) =
                S.lower[e].topLeftCorner(S.rows[row], S.rows[col]);
        }
    }

    Real smallest_pivot() const {
        Real smallest = 1;
        for (Eigen::Index i = 0; i < matrix_.rows(); ++i) {
            const Real l = factors_.matrixLLT()(i, i);
            smallest = min(smallest, Real(l * l / matrix_(i, i)));
        }
        return smallest;
    }

    MatX matrix_;
    Eigen::LLT<MatX> factors_;
};

}  // namespace

std::unique_ptr<BlockSolver> dense_solver(const BlockMatrix& pattern) { return std::make_unique<DenseSolver>(pattern); }

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
