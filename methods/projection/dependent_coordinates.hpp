// SPDX-License-Identifier: BSD-3-Clause
//
// Coordinate partitioning [wehagehaug1982]: Gaussian elimination with complete pivoting of C takes a dependent
// coordinate with each pivot. The coordinates are those of q exp(delta), a chart around the state: axes of space or of
// the bodies, as the formulation has them, so that the choice depends on these, and with it what the correction does to
// a state off the rows. It does not depend on units: translations count over the longest arm, rows over their largest
// entry. Of pivots that differ by less than a thousandth the first one is taken, lest round-off chooses.
// The partition stays until its least pivot falls below a tenth of what it was when it was chosen.
#pragma once

#include <memory>

#include "methods/projection/correction.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// delta_d = C_d^{-1} c in the dependent coordinates of a partition, and nothing in the independent ones.
std::unique_ptr<Correction> in_dependent_coordinates(System& system);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
