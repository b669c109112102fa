// SPDX-License-Identifier: BSD-3-Clause
//
// One cell as one line of JSON: in the journal with its times and a check sum, in the results without.
#pragma once

#include <optional>
#include <string>

#include "records/planned.hpp"

namespace kreisel {

/// A finished cell. `line` is its result line, the same bytes on every run of one build.
struct FinishedCell {
    std::string hash;
    std::string status;
    std::string detail;
    double t_reached = 0;
    std::string line;
    Cost cost;
    std::string trajectory_sum;  ///< hash of the trajectory file; empty where there is none
    bool failed() const { return status != "ok" && status != "skipped"; }
};

/// `trajectory_sum`: of the samples, empty where there are none. Throws std::logic_error if the outcome holds a number
/// that is not finite.
FinishedCell finished_cell(const PlannedCell& planned, const Outcome& outcome, const Reference* reference,
                           const std::string& trajectory_sum = "");

/// The journal line of a cell: its result line, then its times, build and check sum.
std::string journal_line(const FinishedCell& cell, const std::string& build);

/// What a journal line holds, or nothing if it is torn, damaged, or was written by another build.
std::optional<FinishedCell> read_journal_line(const std::string& line, const std::string& build);

/// The hash of the cell that an intact journal line is about, whichever build wrote it; nothing if it is torn or
/// damaged.
std::optional<std::string> journalled_cell(const std::string& line);

/// The result line with the identity members of `planned`, whose label may have changed since.
std::string relabelled(const std::string& line, const PlannedCell& planned);

}  // namespace kreisel
