// SPDX-License-Identifier: BSD-3-Clause
//
// The symbolic phase of a block LDL^T: which blocks the factor has and which updates lead to them, from the pattern of
// the matrix alone. Joints are eliminated in an order of minimum degree (mechanics/blocks/elimination.hpp).
#pragma once

#include <vector>

#include "mechanics/blocks/block_matrix.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Positions are those of the elimination. Blocks 0 ... n-1 are the diagonal, the others follow column by column.
struct FactorPattern {
    explicit FactorPattern(const BlockMatrix& pattern);

    /// Block L(row, k) of column k, row > k.
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

    std::vector<std::size_t> joint_at;         ///< joint at each position
    std::vector<int> rows, offset;             ///< of that joint
    std::vector<std::vector<Below>> columns;   ///< by position
    std::vector<std::vector<Update>> updates;  ///< by position
    std::vector<Source> sources;
    std::size_t blocks = 0;
};

/// Blocks of the factor that the matrix does not have: none for chains and trees, however many joints meet in a body.
std::size_t fill_in(const BlockMatrix& pattern);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
