// SPDX-License-Identifier: BSD-3-Clause
//
// Which of the many delta with C delta = c a projection adds to a state that is off its rows by -c.
#pragma once

#include <memory>

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

/// The least in the metric of the mass matrix: [M C^T; C 0] [delta; .] = [0; c].
std::unique_ptr<Correction> least_in_mass(System& system);
/// The least in velocity coordinates, metres and radians alike: delta = C^T (C C^T)^{-1} c.
std::unique_ptr<Correction> least_in_coordinates(System& system);
/// delta_d = C_d^{-1} c in the dependent coordinates of a partition, and nothing in the independent ones.
std::unique_ptr<Correction> in_dependent_coordinates(System& system);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
