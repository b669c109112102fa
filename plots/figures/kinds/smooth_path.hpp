// SPDX-License-Identifier: BSD-3-Clause
//
// A path between its samples.
#pragma once

#include "plots/figures/kinds/space_kind.hpp"

namespace kreisel {

/// t, x and v at the samples and between them, so that v turns by at most 6 degrees from one point to the next: cubic
/// Hermite interpolation of x and v. A straight line where these do not belong to one smooth arc, since v is not known
/// or the body goes farther from one sample to the next than twice their distance.
BodyPath smooth_path(const BodyPath& samples);

}  // namespace kreisel
