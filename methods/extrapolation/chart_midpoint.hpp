// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "methods/extrapolation/base.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Gragg's rule in the chart of exp around the start of the step. The system outlives it.
std::unique_ptr<ExtrapolationBase> chart_midpoint(System& system, Work& work);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
