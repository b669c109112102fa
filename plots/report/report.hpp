// SPDX-License-Identifier: BSD-3-Clause
//
// A results folder as one page.
#pragma once

#include <filesystem>

#include "records/reading/read_results.hpp"
#include "records/results.hpp"
#include "support/errors.hpp"

namespace kreisel {

/// `kreisel report DIR [-o FILE]`: what was run and what came out as one HTML file that needs no network, by default
/// DIR/report.html. What is damaged, or missing of the `planned` cells, is said, in the page too. Exit::cells_failed
/// where a figure could not be drawn, Exit::io where something is damaged: the page then shows the rest. Locks the
/// folder. Throws FileError.
Exit report_command(const std::filesystem::path& folder, const std::filesystem::path& output,
                    const PlannedCells& planned = {});

}  // namespace kreisel
