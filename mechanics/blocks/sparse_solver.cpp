// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/blocks/sparse_solver.hpp"

#include <Eigen/SparseCholesky>

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

class SparseSolver final : public BlockSolver {
  public:
    explicit SparseSolver(const BlockMatrix& pattern) : matrix_(pattern.size, pattern.size) {
        std::vector<Eigen::Triplet<Real, int>> entries;
        each(pattern, [&](int row, int col, const Real&) { entries.emplace_back(row, col, Real(1)); });
        matrix_.setFromTriplets(entries.begin(), entries.end());
        factors_.analyzePattern(matrix_);
    }

    Real factor(const BlockMatrix& S) override {
        each(S, [&](int row, int col, const Real& value) { matrix_.coeffRef(row, col) = value; });
        factors_.factorize(matrix_);
        if (factors_.info() != Eigen::Success) return 0;
        const auto pivots = factors_.vectorD();
        const auto& place = factors_.permutationP().indices();
        Real smallest = 1;
        for (int i = 0; i < S.size; ++i) smallest = min(smallest, Real(pivots[place[i]] / matrix_.coeff(i, i)));
        return smallest;
    }
    void solve(VecX& b) override { b = factors_.solve(b).eval(); }

  private:
    /// Calls f(row, col, value) for the entries of the lower half.
    template <class F>
    static void each(const BlockMatrix& S, F f) {
        for (std::size_t j = 0; j < S.rows.size(); ++j)
            for (int i = 0; i < S.rows[j]; ++i)
                for (int k = 0; k <= i; ++k) f(S.offset[j] + i, S.offset[j] + k, S.diagonal[j](i, k));
        for (std::size_t e = 0; e < S.entries.size(); ++e) {
            const std::size_t row = at(S.entries[e].row), col = at(S.entries[e].col);
            for (int i = 0; i < S.rows[row]; ++i)
                for (int k = 0; k < S.rows[col]; ++k) f(S.offset[row] + i, S.offset[col] + k, S.lower[e](i, k));
        }
    }

    Eigen::SparseMatrix<Real> matrix_;
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<Real>, Eigen::Lower> factors_;
};

}  // namespace

std::unique_ptr<BlockSolver> sparse_solver(const BlockMatrix& pattern) {
    return std::make_unique<SparseSolver>(pattern);
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
