// SPDX-License-Identifier: BSD-3-Clause
//
// The next value of a vector guessed from equidistant earlier ones, by a polynomial through the last d + 1 of them: the
// sum of the backward differences up to the d-th. The next difference is the error, so the degree is chosen that
// would have guessed the last value best.
#pragma once

#include <array>

#include "lie/linear.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

class Predictor {
  public:
    explicit Predictor(Eigen::Index size) {
        for (VecX& difference : differences_) difference.setZero(size);
        next_.setZero(size);
    }

    void clear() { known_ = 0; }
    bool empty() const { return known_ == 0; }
    /// Appends a new value.
    void push(const VecX& value);
    /// The degree that would have guessed it best; errors are compared by the largest of their first entries, which are
    /// of one unit.
    int best_degree(Eigen::Index entries) const;
    /// By the polynomial of some degree, at most as high as there are values for.
    void guess(int degree, VecX& value) const;

  private:
    static constexpr int most_ = 6;
    std::array<VecX, most_ + 1> differences_;  // of order 0, 1, ...
    VecX next_;
    int known_ = 0;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
