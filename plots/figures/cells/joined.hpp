// SPDX-License-Identifier: BSD-3-Clause
//
// The results of several folders in one figure.
#pragma once

#include <vector>

#include "records/results.hpp"

namespace kreisel {

/// The cells of all, in that order; each names its results by the name of its experiment, and by its folder as well
/// where two have one name, so that they are an axis ("results"). One alone stays as it is.
Results joined(std::vector<Results> all);

}  // namespace kreisel
