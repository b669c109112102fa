// SPDX-License-Identifier: BSD-3-Clause
//
// Constraint drift, first integrals and cost, cell by cell.
#pragma once

#include <filesystem>

#include "plots/tables/cells.hpp"
#include "records/fits/fit.hpp"

namespace kreisel {

/// Growth of the running maximum of a defect or invariant over time (column "<metric>.max" of the trajectory); nothing
/// where it stays below `roundoff_level`, or has no samples.
std::optional<GrowthLaw> growth_of(const TrajectoryTable& trajectory, const std::string& metric,
                                   const std::string& precision);

/// A defect that ends below this is round-off, whatever its growth: 1e4 units of round-off (SI units, sizes about 1),
/// or 10 times eps a T^2/2, to which the round-off of accelerations of size a = max |omega| |v| adds up over the time
/// T.
double roundoff_level(const TrajectoryTable& trajectory, const std::string& precision);

/// The metrics with this prefix ("defect.", "invariant.") and no further suffix, in the order of first appearance.
std::vector<std::string> plain_metrics(const std::vector<ResultRow>& rows, const std::string& prefix);

/// One row per cell and defect: maximum, final value, growth exponent with its spread and the fitted range.
TextTable drift_table(const Results& results, const std::filesystem::path& folder, std::string (*number)(double));
/// One row per cell and first integral: maximum, relative maximum, secular slope with its standard error.
TextTable invariants_table(const Results& results, std::string (*number)(double));
/// One row per cell: solves of the dynamics and projection iterations, in all and per step.
TextTable cost_table(const Results& results);
/// One row per cell that is not ok, with its reason.
TextTable failures_table(const Results& results);

}  // namespace kreisel
