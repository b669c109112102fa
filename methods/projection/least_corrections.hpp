// SPDX-License-Identifier: BSD-3-Clause
//
// Corrections that are the least in a metric.
#pragma once

#include <memory>

#include "methods/projection/correction.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// The least in the metric of the mass matrix: [M C^T; C 0] [delta; .] = [0; c].
std::unique_ptr<Correction> least_in_mass(System& system);
/// The least in velocity coordinates, metres and radians alike: delta = C^T (C C^T)^{-1} c.
std::unique_ptr<Correction> least_in_coordinates(System& system);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
