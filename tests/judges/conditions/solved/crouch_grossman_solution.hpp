// SPDX-License-Identifier: BSD-3-Clause
//
// The digits of a Crouch-Grossman method that its source does not print, and those of a solution embedded in it.
#pragma once

#include "tests/judges/conditions/crouch_grossman_system.hpp"
#include "tests/judges/conditions/solved/published_crouch_grossman.hpp"

namespace kreisel::orders {

struct CrouchGrossmanSolution {
    NumericTableau<Float100> tableau;  ///< to 44 decimals, with b^ on one stage more
    Float100 moved;                    ///< the largest change of a printed coefficient
    Float100 residual;                 ///< of what is returned here
};

/// The order conditions by Newton's method with corrections of least norm, first of the method, then, with its
/// coefficients held, of the order below for the embedded solution. Zeros stay zero. Throws std::runtime_error if a
/// residual does not get below 1e-80.
CrouchGrossmanSolution solve(const PublishedCrouchGrossman& published);

}  // namespace kreisel::orders
