// SPDX-License-Identifier: BSD-3-Clause
//
// Runs one cell and names how it ended.
#pragma once

#include <string>

#include "records/cell/planned.hpp"

namespace kreisel {

/// What is said of one.
inline constexpr const char* not_an_exception = "something other than a std::exception was thrown";

/// The outcome of a cell that ended in none of its steps.
Outcome ended(std::string status, std::string detail);

/// Runs one cell; an exception becomes its status, except a FileError of `samples`, which may be null.
Outcome run_cell(const PlannedCell& planned, const Engine& engine, const Reference* reference, const Watch& watch,
                 SampleSink* samples);

/// The record of a cell that has run. Samples of one that threw are not kept, and have no sum.
CellRecord record_of_run(const PlannedCell& planned, const Outcome& outcome, const Reference* reference,
                         const std::string& samples_sum);

}  // namespace kreisel
