// SPDX-License-Identifier: BSD-3-Clause
//
// The projection inside a step to a tolerance, before it is accepted: what it moves the state by counts as error.
#pragma once

#include <algorithm>
#include <vector>

#include "methods/contract/projection.hpp"
#include "methods/control/error_norm.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

class StepProjection {
  public:
    /// Of states with `size` reals. The projection outlives this.
    StepProjection(Projection& projection, std::size_t size) : projection_(projection), before_(size) {}

    /// Before the first step, and whenever y is not what the last step left.
    void start() {
        undecided_ = false;
        projection_.start();
    }
    /// Projects y, the state at `end` after a step by h. `error`, relative to the tolerance, becomes at least what y is
    /// moved by: the larger of the two decides.
    Status apply(const Real& h, const Real& end, ErrorNorm& norm, Real* y, Real& error) {
        if (undecided_) projection_.retract();
        undecided_ = true;
        std::copy_n(y, before_.size(), before_.begin());
        if (const Status status = projection_.project(end, y); status != Status::ok) return status;
        moved_ = !std::equal(before_.begin(), before_.end(), y);
        if (moved_) error = max(error, norm.distance(h, before_.data(), y));
        return isfinite(error) ? Status::ok : Status::non_finite;
    }
    /// The last one was that of a step which is taken.
    void accept() { undecided_ = false; }
    /// Whether the last one has changed its state.
    bool moved() const { return moved_; }

  private:
    Projection& projection_;
    std::vector<Real> before_;
    bool moved_ = false, undecided_ = false;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
