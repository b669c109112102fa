// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/blocks/graph_solver.hpp"

#include "mechanics/blocks/factor_pattern.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// Right-looking block LDL^T: column k of L D is final when it is reached; D_k is inverted,
/// L = (L D) D^{-1}, and the column is subtracted from those to its right.
class GraphSolver final : public BlockSolver {
  public:
    explicit GraphSolver(const BlockMatrix& matrix)
        : pattern_(matrix),
          blocks_(pattern_.blocks, Mat6::Zero()),
          scaled_(blocks_),
          inverse_pivots_(pattern_.columns.size(), Mat6::Zero()),
          diagonal_(pattern_.columns.size()),
          rhs_(matrix.size) {}

    Real factor(const BlockMatrix& S) override {
        gather(S);
        Real smallest = 1;
        for (std::size_t k = 0; k < pattern_.columns.size(); ++k) {
            const Real pivot = invert_pivot(k);
            if (!(pivot > 0)) return pivot;
            smallest = min(smallest, pivot);
            scale_column(k);
            subtract_column(k);
        }
        return smallest;
    }

    void solve(VecX& b) override {
        rhs_ = b;
        substitute_forward();
        substitute_back(b);
    }

  private:
    int rows(std::size_t k) const { return pattern_.rows[k]; }
    auto part(std::size_t k) { return rhs_.segment(pattern_.offset[k], rows(k)); }

    void gather(const BlockMatrix& S);
    Real invert_pivot(std::size_t k);
    /// L(., k) = (L D)(., k) D_k^{-1}.
    void scale_column(std::size_t k);
    /// S(i, j) -= L(i, k) (L D)(j, k)^T.
    void subtract_column(std::size_t k);
    void substitute_forward();
    void substitute_back(VecX& b);

    FactorPattern pattern_;
    std::vector<Mat6> blocks_, scaled_, inverse_pivots_;  // S then L D; L; D^{-1}
    std::vector<Eigen::Matrix<Real, 6, 1>> diagonal_;     // of S
    VecX rhs_;
};

void GraphSolver::gather(const BlockMatrix& S) {
    const std::size_t n = pattern_.columns.size();
    for (std::size_t i = n; i < blocks_.size(); ++i) blocks_[i].setZero();
    for (std::size_t k = 0; k < n; ++k) {
        blocks_[k] = S.diagonal[pattern_.joint_at[k]];
        diagonal_[k] = blocks_[k].diagonal();
    }
    for (const FactorPattern::Source& source : pattern_.sources) {
        if (source.transposed)
            blocks_[source.block] = S.lower[source.entry].transpose();
        else
            blocks_[source.block] = S.lower[source.entry];
    }
}

/// Cholesky factors of the pivot block, and its inverse from them. Returns the smallest relative pivot.
Real GraphSolver::invert_pivot(std::size_t k) {
    const int n = rows(k);
    Mat6 L = Mat6::Zero();
    Real smallest = 1;
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < i; ++j) L(i, j) = (blocks_[k](i, j) - L.row(i).head(j).dot(L.row(j).head(j))) / L(j, j);
        const Real pivot = blocks_[k](i, i) - L.row(i).head(i).squaredNorm();
        const Real relative = pivot / diagonal_[k][i];
        if (!(relative > 0)) return relative;
        smallest = min(smallest, relative);
        L(i, i) = sqrt(pivot);
    }
    Mat6 inverse = Mat6::Identity();
    const auto triangle = L.topLeftCorner(n, n).template triangularView<Eigen::Lower>();
    auto columns = inverse.topLeftCorner(n, n);
    triangle.solveInPlace(columns);
    inverse_pivots_[k].topLeftCorner(n, n).noalias() = columns.transpose().lazyProduct(columns);
    return smallest;
}

void GraphSolver::scale_column(std::size_t k) {
    const int n = rows(k);
    for (const FactorPattern::Below& below : pattern_.columns[k])
        scaled_[below.block].topLeftCorner(rows(below.row), n) =
            blocks_[below.block].topLeftCorner(rows(below.row), n).lazyProduct(inverse_pivots_[k].topLeftCorner(n, n));
}

void GraphSolver::subtract_column(std::size_t k) {
    const int n = rows(k);
    for (const FactorPattern::Update& update : pattern_.updates[k])
        blocks_[update.target].topLeftCorner(rows(update.left_row), rows(update.right_row)) -=
            scaled_[update.left]
                .topLeftCorner(rows(update.left_row), n)
                .lazyProduct(blocks_[update.right].topLeftCorner(rows(update.right_row), n).transpose());
}

/// L z = b.
void GraphSolver::substitute_forward() {
    for (std::size_t k = 0; k < pattern_.columns.size(); ++k)
        for (const FactorPattern::Below& below : pattern_.columns[k])
            part(below.row) -= scaled_[below.block].topLeftCorner(rows(below.row), rows(k)).lazyProduct(part(k));
}

/// D L^T x = z.
void GraphSolver::substitute_back(VecX& b) {
    for (std::size_t k = pattern_.columns.size(); k-- > 0;) {
        auto x = b.segment(pattern_.offset[k], rows(k));
        x = inverse_pivots_[k].topLeftCorner(rows(k), rows(k)).lazyProduct(part(k));
        for (const FactorPattern::Below& below : pattern_.columns[k])
            x -= scaled_[below.block].topLeftCorner(rows(below.row), rows(k)).transpose().lazyProduct(part(below.row));
        part(k) = x;
    }
}

}  // namespace

std::unique_ptr<BlockSolver> graph_solver(const BlockMatrix& pattern) { return std::make_unique<GraphSolver>(pattern); }

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
