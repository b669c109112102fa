// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/solve/block_matrix.hpp"

#include <Eigen/Cholesky>
#include <Eigen/SparseCholesky>
#include <map>

#include "mechanics/solve/elimination.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

class DenseSolver final : public BlockSolver {
  public:
    explicit DenseSolver(const BlockMatrix& pattern)
        : matrix_(MatX::Zero(pattern.size, pattern.size)), factors_(pattern.size) {}

    Real factor(const BlockMatrix& S) override {
        for (std::size_t j = 0; j < S.rows.size(); ++j)
            matrix_.block(S.offset[j], S.offset[j], S.rows[j], S.rows[j]) =
                S.diagonal[j].topLeftCorner(S.rows[j], S.rows[j]);
        for (std::size_t e = 0; e < S.entries.size(); ++e) {
            const std::size_t row = at(S.entries[e].row), col = at(S.entries[e].col);
            matrix_.block(S.offset[row], S.offset[col], S.rows[row], S.rows[col]) =
                S.lower[e].topLeftCorner(S.rows[row], S.rows[col]);
        }
        factors_.compute(matrix_);  // reads the lower half
        if (factors_.info() != Eigen::Success) return 0;
        Real smallest = 1;
        for (Eigen::Index i = 0; i < matrix_.rows(); ++i) {
            const Real l = factors_.matrixLLT()(i, i);
            smallest = min(smallest, Real(l * l / matrix_(i, i)));
        }
        return smallest;
    }
    void solve(VecX& b) override { factors_.solveInPlace(b); }

  private:
    MatX matrix_;
    Eigen::LLT<MatX> factors_;
};

class GraphSolver final : public BlockSolver {
  public:
    explicit GraphSolver(const BlockMatrix& pattern);
    Real factor(const BlockMatrix& S) override;
    void solve(VecX& b) override;

  private:
    /// Block L(row, k) of the factor, row > k in elimination order.
    struct Below {
        std::size_t row, block;
    };
    /// target -= left * right^T while a column is eliminated; left_row >= right_row.
    struct Update {
        std::size_t target, left, right, left_row, right_row;
    };
    /// The place of an entry of the matrix.
    struct Source {
        std::size_t entry, block;
        bool transposed;
    };
    Real invert_pivot(std::size_t k);

    std::vector<std::size_t> joint_at_;
    std::vector<int> rows_, offset_;  // by elimination position
    std::vector<std::vector<Below>> columns_;
    std::vector<std::vector<Update>> updates_;
    std::vector<Source> sources_;
    std::vector<Mat6> blocks_, scaled_, inverse_pivots_;  // S then L D; L; D^{-1}
    std::vector<Eigen::Matrix<Real, 6, 1>> diagonal_;     // of S
    VecX rhs_;
};

GraphSolver::GraphSolver(const BlockMatrix& pattern) : rhs_(pattern.size) {
    const std::size_t joints = pattern.rows.size();
    std::vector<std::set<int>> adjacent(joints);
    for (const auto& [row, col] : pattern.entries) adjacent[at(row)].insert(col), adjacent[at(col)].insert(row);
    const Elimination order = eliminate(std::move(adjacent));
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> block;
    for (std::size_t k = 0; k < joints; ++k) {
        block[{k, k}] = k;
        joint_at_.push_back(at(order.order[k]));
        rows_.push_back(pattern.rows[joint_at_[k]]), offset_.push_back(pattern.offset[joint_at_[k]]);
    }
    columns_.resize(joints), updates_.resize(joints);
    for (std::size_t k = 0; k < joints; ++k)
        for (const int row : order.neighbours[k]) {
            const std::size_t next = block.size();
            block[{at(row), k}] = next;
            columns_[k].push_back({at(row), next});
        }
    for (std::size_t k = 0; k < joints; ++k)
        for (const Below& right : columns_[k])
            for (const Below& left : columns_[k])
                if (left.row >= right.row)
                    updates_[k].push_back(
                        {block.at({left.row, right.row}), left.block, right.block, left.row, right.row});
    for (std::size_t e = 0; e < pattern.entries.size(); ++e) {
        const std::size_t row = at(order.position[at(pattern.entries[e].row)]);
        const std::size_t col = at(order.position[at(pattern.entries[e].col)]);
        sources_.push_back({e, block.at({max(row, col), min(row, col)}), row < col});
    }
    blocks_.assign(block.size(), Mat6::Zero());
    scaled_ = blocks_;
    inverse_pivots_.assign(joints, Mat6::Zero());
    diagonal_.resize(joints);
}

/// Cholesky factors of the pivot block, and its inverse from them. Returns the smallest relative pivot.
Real GraphSolver::invert_pivot(std::size_t k) {
    const int n = rows_[k];
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

Real GraphSolver::factor(const BlockMatrix& S) {
    for (std::size_t i = columns_.size(); i < blocks_.size(); ++i) blocks_[i].setZero();
    for (std::size_t k = 0; k < columns_.size(); ++k) {
        blocks_[k] = S.diagonal[joint_at_[k]];
        diagonal_[k] = blocks_[k].diagonal();
    }
    for (const Source& source : sources_) {
        if (source.transposed)
            blocks_[source.block] = S.lower[source.entry].transpose();
        else
            blocks_[source.block] = S.lower[source.entry];
    }
    Real smallest = 1;
    for (std::size_t k = 0; k < columns_.size(); ++k) {
        const Real pivot = invert_pivot(k);
        if (!(pivot > 0)) return pivot;
        smallest = min(smallest, pivot);
        const int n = rows_[k];
        for (const Below& below : columns_[k])
            scaled_[below.block].topLeftCorner(rows_[below.row], n) =
                blocks_[below.block]
                    .topLeftCorner(rows_[below.row], n)
                    .lazyProduct(inverse_pivots_[k].topLeftCorner(n, n));
        for (const Update& update : updates_[k])
            blocks_[update.target].topLeftCorner(rows_[update.left_row], rows_[update.right_row]) -=
                scaled_[update.left]
                    .topLeftCorner(rows_[update.left_row], n)
                    .lazyProduct(blocks_[update.right].topLeftCorner(rows_[update.right_row], n).transpose());
    }
    return smallest;
}

void GraphSolver::solve(VecX& b) {
    rhs_ = b;
    const auto part = [&](std::size_t k) { return rhs_.segment(offset_[k], rows_[k]); };
    const std::size_t n = columns_.size();
    for (std::size_t k = 0; k < n; ++k)
        for (const Below& below : columns_[k])
            part(below.row) -= scaled_[below.block].topLeftCorner(rows_[below.row], rows_[k]).lazyProduct(part(k));
    for (std::size_t k = n; k-- > 0;) {
        auto x = b.segment(offset_[k], rows_[k]);
        x = inverse_pivots_[k].topLeftCorner(rows_[k], rows_[k]).lazyProduct(part(k));
        for (const Below& below : columns_[k])
            x -=
                scaled_[below.block].topLeftCorner(rows_[below.row], rows_[k]).transpose().lazyProduct(part(below.row));
        part(k) = x;
    }
}

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

constexpr int most_dense_rows = 24;

/// Fill-in of the elimination, in blocks: none for chains and trees, however many joints meet in a body.
std::size_t fill(const BlockMatrix& pattern) {
    std::vector<std::set<int>> adjacent(pattern.rows.size());
    for (const auto& [row, col] : pattern.entries) adjacent[at(row)].insert(col), adjacent[at(col)].insert(row);
    std::size_t blocks = 0;
    for (const auto& below : eliminate(std::move(adjacent)).neighbours) blocks += below.size();
    return blocks - pattern.entries.size();
}

}  // namespace

void BlockMatrix::add_joint(int count) {
    rows.push_back(count), offset.push_back(size);
    size += count;
    diagonal.push_back(Mat6::Zero());
}

std::unique_ptr<BlockSolver> dense_solver(const BlockMatrix& pattern) { return std::make_unique<DenseSolver>(pattern); }
std::unique_ptr<BlockSolver> graph_solver(const BlockMatrix& pattern) { return std::make_unique<GraphSolver>(pattern); }
std::unique_ptr<BlockSolver> sparse_solver(const BlockMatrix& pattern) {
    return std::make_unique<SparseSolver>(pattern);
}

std::unique_ptr<BlockSolver> make_solver(const BlockMatrix& pattern, SolverChoice choice) {
    switch (choice) {
        case SolverChoice::dense:
            return dense_solver(pattern);
        case SolverChoice::graph:
            return graph_solver(pattern);
        case SolverChoice::sparse:
            return sparse_solver(pattern);
        case SolverChoice::automatic:
            break;
    }
    if (pattern.size <= most_dense_rows) return dense_solver(pattern);
    return 4 * fill(pattern) <= pattern.entries.size() ? graph_solver(pattern) : sparse_solver(pattern);
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
