// SPDX-License-Identifier: BSD-3-Clause
//
// Figures of a config of which --filter left a part: they show what is there, and warnings say what is missing.
#pragma once

#include <string>
#include <vector>

#include "driver/plan/plan.hpp"

namespace kreisel {

/// What check_figures reports that no problem which --filter took can be the reason of.
void check_filtered_figures(const Document& document, const Plan& plan, const std::vector<std::string>& metrics,
                            const Engine& engine, Diagnostics& sink);

/// Takes out of the figures what --filter took from the config: values under `select`, names of curves; and figures of
/// which nothing is left to draw. Adds a warning for each that is not as written. The plan has its cells.
void narrow_figures(const std::vector<std::string>& metrics, const Engine& engine, Plan& plan);

}  // namespace kreisel
