// SPDX-License-Identifier: BSD-3-Clause
//
// How the defects and invariants of a trajectory grow.
#pragma once

#include <optional>
#include <string>

#include "records/fits/fit.hpp"
#include "records/reading/trajectory_table.hpp"
#include "records/results.hpp"

namespace kreisel {

/// Growth of the running maximum of a defect or invariant over time (column "<metric>.max" of the trajectory); nothing
/// where it stays below `roundoff_level`, or has no samples.
std::optional<GrowthLaw> growth_of(const TrajectoryTable& trajectory, const std::string& metric,
                                   const std::string& precision);

/// A defect that ends below this is round-off, whatever its growth: 1e4 units of round-off (SI units, sizes about 1),
/// or 10 times eps a T^2/2, to which the round-off of accelerations of size a = max |omega| |v| adds up over the time
/// T.
double roundoff_level(const TrajectoryTable& trajectory, const std::string& precision);

}  // namespace kreisel
