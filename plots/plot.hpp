// SPDX-License-Identifier: BSD-3-Clause
//
// Figures from the results of a run.
#pragma once

#include <filesystem>

#include "support/errors.hpp"

namespace kreisel {

/// `kreisel plot DIR`: draws the figures that the config asks for (key "figure", see plots/figures/spec.hpp; one figure
/// of the experiment's kind where it asks for none) as DIR/figures/<name>.{pdf,svg,png}, with gnuplot, from plain data
/// files under DIR/plotdata/. Exit::cells_failed where a figure could not be drawn, Exit::io where result lines are
/// damaged: the figures then show the others. Throws FileError.
Exit plot_command(const std::filesystem::path& folder);

}  // namespace kreisel
