// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tests/metamorphic/selection.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {
namespace metamorphic {

/// "" or what speaks against two runs that agree up to truncation: their distance at the end must be no larger than the sum
/// of their errors, each against a far finer run of its own description (in double, where that is quick), and
/// fall at the declared order between two of the step sizes h/2, ... h/16, unless all that is left of it is round-off.
std::string beyond_truncation(const Case& entry, const Transformed& changed, int steps, const Bench& bench);

}  // namespace metamorphic
}  // namespace KREISEL_PRECISION
}  // namespace kreisel
