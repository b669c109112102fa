// SPDX-License-Identifier: BSD-3-Clause
//
// Gragg-Bulirsch-Stoer extrapolation of fixed order and fixed big step, for w' = f(t, w) in R^d.
//
// T_j1 is the result of the modified midpoint rule with n_j (even) substeps of length h = H/n_j,
//   z_1 = w + h f(t, w),   z_{i+1} = z_{i-1} + 2 h f(t + i h, z_i),   T_j1 = z_n,
// whose error has an expansion in h^2 at even steps, so that Gragg's smoothing step is not needed. Aitken-Neville
// extrapolation to h = 0 in the abscissae (H/n_j)^2 gives order 2k with k columns.
// Sources: [gragg1965], [bulirschstoer1966], [hairer1993, Sec. II.9].
#pragma once

#include <functional>
#include <vector>

#include "lie/real.hpp"
#include "lie/status.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Substeps n_j of each row, and the abscissa that row has in the extrapolation, in units of a power of H.
struct ExtrapolationTable {
    std::vector<int> steps;
    std::vector<Real> abscissae;
};

/// n_j = 2, 4, ..., 2k with abscissae 1/n_j^2.
ExtrapolationTable even_sequence(int columns);

/// One object per thread: it owns its work space.
class Extrapolation {
  public:
    /// Writes f(t, w) to its last argument.
    using Rate = std::function<Status(const Real& t, const Real* w, Real* rate)>;

    /// Throws std::invalid_argument if a row has an odd number of substeps, or there are no rows.
    Extrapolation(ExtrapolationTable table, int dimension, Rate rate);

    /// w <- T_kk over [t, t + H]; unchanged unless it returns Status::ok.
    Status step(const Real& t, const Real& H, Real* w);

    /// T_kk - T_{k,k-1} of the last step: the error of the next lower order, 2k - 2 (zeros where k = 1).
    const std::vector<Real>& difference() const { return difference_; }
    int order() const { return 2 * static_cast<int>(table_.steps.size()); }

  private:
    Status midpoint(const Real& t, const Real& H, int steps, const Real* w, std::vector<Real>& end);
    void extrapolate(std::size_t row);

    ExtrapolationTable table_;
    Rate rate_;
    std::vector<Real> start_rate_, slope_, before_, difference_;
    std::vector<std::vector<Real>> rows_;  // rows_[i] = T_{j,j-i+1} once row j is in the table
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
