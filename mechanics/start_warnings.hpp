// SPDX-License-Identifier: BSD-3-Clause
//
// What is said of a start that is allowed.
#pragma once

#include <string>
#include <vector>

#include "mechanics/model/model.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Warnings about a model whose start is allowed: a singular position, where the rank of the constraints is lower than
/// nearby; rows so nearly dependent, by position or by the ratio of masses, that a solve keeps fewer than six digits
/// (both for at most 120 rows); a torsion spring whose axes the joints allow to part.
std::vector<std::string> start_warnings(const Model& model);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
