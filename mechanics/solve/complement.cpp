// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/solve/complement.hpp"

#include <map>
#include <utility>

namespace kreisel {
inline namespace KREISEL_PRECISION {

Complement::Complement(const ConstraintMatrix& C, SolverChoice choice) {
    for (std::size_t j = 0; j < C.joints(); ++j) matrix_.add_joint(C.rows(j));
    connect(C);
    solver_ = make_solver(matrix_, choice);
}

void Complement::connect(const ConstraintMatrix& C) {
    std::map<std::size_t, std::vector<std::size_t>> on_body;
    for (std::size_t e = 0; e < C.ends().size(); ++e) on_body[C.ends()[e].body].push_back(e);
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> entry;
    for (const auto& [body, ends] : on_body)
        for (const std::size_t a : ends)
            for (const std::size_t b : ends) {
                const std::size_t row = C.ends()[a].joint, col = C.ends()[b].joint;
                if (row < col) continue;
                if (row == col) {
                    pairs_.push_back({a, b, row, true});
                    continue;
                }
                const auto [place, fresh] = entry.insert({{row, col}, matrix_.entries.size()});
                if (fresh) matrix_.entries.push_back({static_cast<int>(row), static_cast<int>(col)});
                pairs_.push_back({a, b, place->second, false});
            }
    matrix_.lower.assign(matrix_.entries.size(), Mat6::Zero());
}

Real Complement::factor(const ConstraintMatrix& C, const RowSelection& selection) {
    assemble(C);
    if (!selection.is_complete()) drop_rows(C, selection);
    return solver_->factor(matrix_);
}

/// The block of two joints is the sum of W_row^T M^{-1} W_col over the bodies they share.
void Complement::assemble(const ConstraintMatrix& C) {
    for (Mat6& block : matrix_.diagonal) block.setZero();
    for (Mat6& block : matrix_.lower) block.setZero();
    for (const EndPair& pair : pairs_) {
        const ConstraintMatrix::End &a = C.ends()[pair.row_end], &b = C.ends()[pair.col_end];
        const int rows = C.rows(a.joint), cols = C.rows(b.joint);
        Mat6& block = pair.diagonal ? matrix_.diagonal[pair.block] : matrix_.lower[pair.block];
        block.topLeftCorner(rows, cols) += a.W->leftCols(rows).transpose().lazyProduct(b.mobility.leftCols(cols));
    }
}

void Complement::drop_rows(const ConstraintMatrix& C, const RowSelection& selection) {
    const auto dropped = [&](std::size_t joint, int k) {
        return k < C.rows(joint) && !selection.is_kept(C.at(joint, k));
    };
    for (std::size_t j = 0; j < C.joints(); ++j)
        for (int k = 0; k < most_rows; ++k) {
            if (!dropped(j, k)) continue;
            matrix_.diagonal[j].row(k).setZero(), matrix_.diagonal[j].col(k).setZero();
            matrix_.diagonal[j](k, k) = 1;
        }
    for (std::size_t e = 0; e < matrix_.entries.size(); ++e) {
        const auto row = static_cast<std::size_t>(matrix_.entries[e].row),
                   col = static_cast<std::size_t>(matrix_.entries[e].col);
        for (int k = 0; k < most_rows; ++k) {
            if (dropped(row, k)) matrix_.lower[e].row(k).setZero();
            if (dropped(col, k)) matrix_.lower[e].col(k).setZero();
        }
    }
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
