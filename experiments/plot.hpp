// SPDX-License-Identifier: BSD-3-Clause
//
// Figures from the results of a run.
#pragma once

#include <filesystem>

namespace kreisel {

/// `kreisel plot DIR`: draws the figures that the config asks for (key "figure", see figure.hpp; one figure of the
/// experiment's kind where it asks for none) as DIR/figures/<name>.{pdf,svg,png}, with gnuplot, from plain data files
/// under DIR/plotdata/. Returns an exit code: 0, or 1 where a figure could not be drawn. Throws FileError.
int plot_command(const std::filesystem::path& folder);

}  // namespace kreisel
