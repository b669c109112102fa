// SPDX-License-Identifier: BSD-3-Clause
//
// The Gauss methods with 2 and 3 stages, of order 4 and 6, in closed form [hairer2006, II.1.3].
#pragma once

#include "methods/implicit/stages/implicit_stages.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Of 2 or 3 stages.
StageCoefficients gauss_coefficients(int stages);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
