// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mechanics/system.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// How much the round-off of places matters in the directions of joints: rows along a line between bodies have its
/// direction to the round-off of places over its length.
class Remoteness {
  public:
    explicit Remoteness(System& system)
        : system_(system),
          terms_(VecX::Zero(system.position_constraints())),
          lengths_(VecX::Zero(system.constraints())) {}

    /// The largest ratio of the size of positions to that of the joints at q, at least 1.
    Real measure(const Real* q) {
        if (terms_.size() == 0) return 1;
        system_.position_scale(q, terms_.data());
        system_.row_scale(lengths_.data());
        return max(Real(1), Real(terms_.cwiseQuotient(lengths_.head(terms_.size())).maxCoeff()));
    }

  private:
    System& system_;
    VecX terms_, lengths_;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
