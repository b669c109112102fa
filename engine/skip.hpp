// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "engine/engine.hpp"
#include "lie/real.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Why a cell cannot run; empty if it can. Throws ParameterError, OptionError, and std::out_of_range for names that are
/// not registered.
std::string why_skipped(const Cell& cell);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
