// SPDX-License-Identifier: BSD-3-Clause
//
// The Schur complement S = C M^{-1} C^T of spherical joints, as a sparse matrix of 3x3 blocks over the joint graph,
// and its block LDL^T. Rows of a joint are in the axes of its second body. Then the contribution of a body to
// S_jl is s_j s_l E_j K E_l^T with the constant K = I/m - r_j^ J^{-1} r_l^ (points r in body axes), signs s = +1 for
// the first and -1 for the second body of a joint, and E the identity for the second body and the relative rotation
// R_second^T R_first for the first: at run time only relative rotations enter. Where no joint links two moving bodies
// S is constant, and factored once.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lie/status.hpp"
#include "mechanics/model.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

class SchurComplement {
  public:
    explicit SchurComplement(const Model& model);

    /// True if S does not depend on the configuration; then factor() is not needed.
    bool is_constant() const { return moving_.empty(); }
    /// Assembles and factors S; `relative[j]` = R_second^T R_first of joint j (unused where the first is ground).
    Status factor(const Mat3* relative);
    /// Solves S x = b in place; one block of b per joint, in the order of the model.
    void solve(Vec3* b) const {
        if (columns_.size() == 1)
            *b = inverse_pivots_[0] * *b;
        else
            substitute(b);
    }
    /// Names the joint at which a factorisation failed last; empty if none has.
    std::string singularity(const Model& model) const;
    /// Status of the factorisation of a constant S.
    Status status() const { return status_; }

  private:
    /// E_row K E_col^T is added to a block; -1 stands for the identity.
    struct Term {
        int block, row, col;
        Mat3 K;
    };
    /// Block L(row, k) of the factor, row > k in elimination order.
    struct Entry {
        int row, block;
    };
    /// target -= left * right^T while eliminating a column.
    struct Update {
        int target, left, right;
    };

    Status factor_blocks();
    void substitute(Vec3* b) const;

    std::vector<int> joint_at_;                 // elimination position -> joint
    std::vector<std::vector<Entry>> columns_;   // below-diagonal blocks of each column
    std::vector<std::vector<Update>> updates_;  // of each column
    std::vector<Term> moving_;
    std::vector<Mat3> constant_;        // the constant part of S; blocks 0 ... joints-1 are the diagonal
    std::vector<Mat3> blocks_;          // S, then L D
    std::vector<Mat3> scaled_;          // L
    std::vector<Mat3> inverse_pivots_;  // D^{-1}
    std::vector<Real> sizes_;           // traces of the diagonal of S
    mutable std::vector<Vec3> rhs_;
    Status status_ = Status::ok;
    std::optional<std::size_t> failed_;  // column of the last pivot that was round-off
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
