// SPDX-License-Identifier: BSD-3-Clause
//
// What is said of a start that is allowed.
#pragma once

#include <string>
#include <vector>

#include "mechanics/model/model.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// What a model whose start is allowed is warned of: a singular position, where the rank of the constraints is less than
/// beside it; rows so nearly dependent, in position or by the ratio of masses, that a solve keeps fewer than six digits (of
/// at most 120 rows, both); a torsion spring whose axes the joints let part.
std::vector<std::string> start_warnings(const Model& model);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
