// SPDX-License-Identifier: BSD-3-Clause
//
// Aitken-Neville extrapolation to h = 0 of rows T_{j,1} with n_j substeps, whose error has an expansion in h^2:
//   T_{j,i+1} = T_{j,i} + (T_{j,i} - T_{j-1,i}) / ((n_j/n_{j-i})^2 - 1),   i = 1 ... j-1 [hairer1993, eq. II.9.10].
// Rows have the substeps 2, 4, 6, ...: of all sequences of even numbers that with the fewest solves for k columns,
// 1 + k^2. What it costs is round-off: T_kk has sum_j |w_j| times that of its rows, 6 times for k = 4, 13 for k = 5 and
// 119 for k = 8. Bulirsch's 2, 4, 6, 8, 12, 16, 24, 32 stays below 10, with half as many solves again: 97, not 65, for
// k = 8.
#pragma once

#include <cstddef>
#include <vector>

#include "lie/real.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Substeps of row j = 1, 2, ...
constexpr int substeps(int row) { return 2 * row; }
/// Solves of the dynamics of k rows: the first slope is common to all.
constexpr int solves_of_rows(int k) { return 1 + k * k; }

class NevilleTable {
  public:
    NevilleTable(int columns, int dimension);

    /// Where the result of row j = 1, 2, ... belongs.
    Real* row(int j) { return rows_[static_cast<std::size_t>(j - 1)].data(); }
    /// With rows 1 to j - 1 extrapolated and T_{j,1} in its place, T_jj follows.
    void extrapolate(int j);
    std::size_t dimension() const { return difference_.size(); }
    /// T_jj of the last row.
    const Real* result() const { return rows_[0].data(); }
    /// T_jj - T_{j,j-1} of the last row, j > 1: the error of the latter.
    const Real* difference() const { return difference_.data(); }

  private:
    std::vector<std::vector<Real>> rows_;  // rows_[i-1] = T_{j,j-i+1} once row j is extrapolated
    std::vector<Real> difference_;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
