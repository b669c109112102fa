// SPDX-License-Identifier: BSD-3-Clause
//
// A sparse symmetric positive definite matrix of small dense blocks, one row of blocks per joint. Vectors hold their
// entries joint by joint.
#pragma once

#include <cstddef>
#include <vector>

#include "lie/linear.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

using Mat6 = Eigen::Matrix<Real, 6, 6>;

/// A joint or an entry as an index of a vector.
inline std::size_t at(int i) { return static_cast<std::size_t>(i); }

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

    void add_joint(int count) {
        rows.push_back(count), offset.push_back(size);
        size += count;
        diagonal.push_back(Mat6::Zero());
    }
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
