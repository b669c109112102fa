// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "methods/extrapolation/base.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// The rule on the group. The system outlives it.
std::unique_ptr<ExtrapolationBase> group_midpoint(System& system, Work& work);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
