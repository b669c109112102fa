// SPDX-License-Identifier: BSD-3-Clause
//
// Figures from the results of a run.
#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "records/results.hpp"
#include "support/errors.hpp"

namespace kreisel {

struct PlotSettings {
    std::vector<std::filesystem::path> folders;  ///< of results; at least one
    std::filesystem::path figure;                ///< a file that describes figures; empty: those of the config
    std::filesystem::path output;                ///< where they are drawn; empty: in the first folder
};

/// The cells that were planned in a folder.
using PlannedIn = std::function<std::vector<CellIdentity>(const std::filesystem::path&)>;

/// `kreisel plot DIR...`: draws the figures that the config of the first folder, or a file, asks for (key "figure", see
/// plots/figures/spec.hpp; one figure of the experiment's kind where it asks for none) as
/// OUTPUT/figures/<name>.{pdf,svg,png}, with gnuplot, from plain data files under OUTPUT/plotdata/. What is damaged, or
/// missing of the `planned` cells, is said, in the figure too. Exit::cells_failed where a figure could not be drawn,
/// Exit::io where something is damaged: the figures then show the rest. Locks the folders. Throws FileError; UsageError
/// for several folders without a file.
Exit plot_command(const PlotSettings& settings, const PlannedIn& planned = {});

}  // namespace kreisel
