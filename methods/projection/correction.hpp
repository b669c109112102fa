// SPDX-License-Identifier: BSD-3-Clause
//
// Which of the many delta with C delta = c a projection adds to a state that is off its rows by -c.
#pragma once

#include "mechanics/system.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

class Correction {
  public:
    virtual ~Correction() = default;
    /// What it remembers of earlier states is dropped.
    virtual void start() {}
    /// delta (n) with C(t, q) delta = c (m). Allocates nothing. non_finite, or singular_kkt where C has lost rank.
    virtual Status solve(const Real& t, const Real* q, const Real* c, Real* delta) = 0;
};

/// C at a configuration, and the number of rows that are independent at the start.
struct DenseRows {
    explicit DenseRows(System& system)
        : rank(system.constraint_rank().rank), C(system.constraints(), system.velocities()) {}
    bool evaluate(const System& system, const Real& t, const Real* q) {
        system.jacobian(t, q, C.data());
        return C.allFinite();
    }

    Eigen::Index rank;
    MatX C;
};

/// A pivot at most this, relative to the first one, stands for a row that depends on others.
inline const Real dependent_pivot = 64 * epsilon;

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
