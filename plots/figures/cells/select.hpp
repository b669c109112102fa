// SPDX-License-Identifier: BSD-3-Clause
//
// Which cells and samples a figure draws.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "plots/figures/figure.hpp"
#include "records/reading/trajectory_table.hpp"
#include "records/results.hpp"

namespace kreisel {

/// The rows that `spec.select` leaves, except skipped ones; with `failed` also those that did not finish.
/// Throws FigureError where none is left.
std::vector<ResultRow> selected_rows(const FigureSpec& spec, const Results& results, bool failed = false);

/// The one cell with samples that a figure of a trajectory draws. Throws FigureError unless there is exactly one.
ResultRow selected_trajectory(const FigureSpec& spec, const Results& results);

/// The rows of `rows` that hold samples. Throws FigureError where there are none.
std::vector<ResultRow> with_samples(std::vector<ResultRow> rows, const FigureSpec& spec);

/// The samples of a cell, up to the time `until` (s) if there is one.
TrajectoryTable samples_until(std::optional<double> until, const ResultRow& row);

/// The body that the figure draws: `wanted`, or the first if that is empty. Throws FigureError where there is no such
/// body.
std::string body_of(const FigureSpec& spec, const std::string& wanted, const TrajectoryTable& trajectory);

}  // namespace kreisel
