// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tests/metamorphic/selection.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {
namespace metamorphic {

/// "" or the objection to two runs that should agree up to truncation: their distance at the end must be at most the
/// sum of their errors, each against a much finer run of its own description (in double, where that is quick), and
/// fall at the declared order between two of the step sizes h/2, ... h/16, unless only round-off is left of it.
std::string beyond_truncation(const Case& entry, const Transformed& changed, int steps, const Bench& bench);

}  // namespace metamorphic
}  // namespace KREISEL_PRECISION
}  // namespace kreisel
