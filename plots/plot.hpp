// SPDX-License-Identifier: BSD-3-Clause
//
// Figures from the results of a run.
#pragma once

#include <filesystem>

#include "records/results.hpp"
#include "support/errors.hpp"

namespace kreisel {

/// `kreisel plot DIR`: draws the figures that the config asks for (key "figure", see plots/figures/spec.hpp; one figure
/// of the experiment's kind where it asks for none) as DIR/figures/<name>.{pdf,svg,png}, with gnuplot, from plain data
/// files under DIR/plotdata/. What is damaged, or missing of the `planned` cells, is said, in the figure too.
/// Exit::cells_failed where a figure could not be drawn, Exit::io where something is damaged: the figures then show the
/// rest. Locks the folder. Throws FileError.
Exit plot_command(const std::filesystem::path& folder, const PlannedCells& planned = {});

}  // namespace kreisel
