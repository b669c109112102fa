// SPDX-License-Identifier: BSD-3-Clause
//
// Order and step of an extrapolation by work per unit step [hairer1993, Sec. II.9]. With err_j the error of T_{j,j-1}
// relative to the tolerance in a step by H, and A_j the solves of j rows,
//   H_j = H S_1 (S_2/err_j)^{1/(2j-1)},   W_j = A_j / H_j,   S_1 = 0.94, S_2 = 0.65.
// k columns are aimed at, and a step is accepted in line k - 1, k or k + 1 of the table, or given up as soon as the
// error shows that it will not be. The next k has the least work per unit step; it goes up or down only where that
// saves a tenth.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "lie/real.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

class OrderAndStep {
  public:
    /// Up to k + 1 = `columns` > 3 of them.
    explicit OrderAndStep(int columns) : columns_(columns), sizes_(static_cast<std::size_t>(columns)) {}

    /// The k to begin with at a tolerance, 0.6 log10(1/tol) + 1.5 rounded down, within its limits.
    static int first_aim(const Real& tolerance, int columns);
    void start(int aim, const Real& step) { aim_ = aim, step_ = step, unknown_ = true, after_rejection_ = false; }

    const Real& step() const { return step_; }  ///< the proposed H, with its sign
    int last_line() const { return aim_ + 1; }

    /// A step by H begins, the proposed one or, `shortened`, less than it, which may converge in any line; so may the
    /// first step.
    void begin(const Real& H, bool shortened);
    enum class Verdict { accept, next_line, reject };
    /// On line j > 1, in order, whose error relative to the tolerance is finite.
    Verdict judge(int j, const Real& error);
    void accepted(int j);
    /// In line j, or 1 where a status ended the step.
    void rejected(int j);

  private:
    Real& size(int j) { return sizes_[static_cast<std::size_t>(j - 1)]; }
    Real work(int j);
    int best_after(int j);
    Real with_sign(const Real& size) const { return H_ < 0 ? -size : size; }

    int columns_, aim_ = 2;
    Real step_ = 0, H_ = 0;
    bool unknown_ = true;  // nothing is known of steps like this one
    bool shortened_ = false, after_rejection_ = false;
    std::vector<Real> sizes_;  // |H_j|
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
