// SPDX-License-Identifier: BSD-3-Clause
//
// Names in the keys "legend" and "order" of figures, before there are curves.
#pragma once

#include <vector>

#include "plots/figures/figure.hpp"
#include "records/json/diagnostics.hpp"

namespace kreisel {

/// Whether the keys of a figure name curves.
bool names_curves(const Figure& figure);

/// Refuses names that no curve of these cells can have, which are those that the figure may draw. Which axes vary is
/// known when cells have ended: a name may be made of the values of any axes, with any options of a method or
/// projection.
void check_curve_names(const Figure& figure, const std::vector<ResultRow>& cells, Diagnostics& sink);

}  // namespace kreisel
