// SPDX-License-Identifier: BSD-3-Clause
//
// The coefficients that a method declares, as text.
#pragma once

#include <optional>
#include <vector>

#include "engine/engine.hpp"
#include "methods/contract/scheme.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// A row for each stage, one for the step, and one for the solution it is compared with, if any; of products of
/// exponentials a row for each factor. None of a family that has other data.
std::vector<SchemeRow> scheme_rows(const std::optional<Scheme>& scheme);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
