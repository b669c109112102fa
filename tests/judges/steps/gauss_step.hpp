// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tests/judges/methods/checks.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// A step of methods/rkmk/gauss.hpp with s stages; in coordinates around q instead of the middle, if a control
/// requires it.
Objection gauss_step_objection(const Method&, int stages, bool around_start = false);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
