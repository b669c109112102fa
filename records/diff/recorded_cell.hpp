// SPDX-License-Identifier: BSD-3-Clause
//
// A cell of a results folder with every digit, as a comparison needs it. What a line lacks is absent, members unknown
// here are ignored: lines of older and newer versions can be read.
#pragma once

#include <map>
#include <string>

#include "records/diff/recorded_number.hpp"

namespace kreisel {

/// One number of a cell. All of one family have the same unit: "final.x" are the positions of all bodies,
/// "final.multipliers [N]" all multipliers that are forces; a metric is a family of its own.
struct RecordedQuantity {
    std::string family;
    RecordedNumber number;
};

using RecordedQuantities = std::map<std::string, RecordedQuantity>;  ///< by name: "final.rod.x.1", "error.position"

struct RecordedCell {
    std::string cell;    ///< the hash; for people, and for finding its trajectory
    std::string label;   ///< of the problem
    std::string status;  ///< "ok", "skipped", or why it failed
    double t_end = 0;    ///< s; 0 if the line does not have it
    /// What was run, by member: "problem", "parameters.mass", "options.coordinates", "steps". Numbers are
    /// written in a canonical way, so that equal numbers are equal texts.
    std::map<std::string, std::string> identity;
    RecordedQuantities final_state, metrics;
    RecordedQuantities others;   ///< counts, rank and condition of the constraints, accuracy of the reference
    std::string trajectory_sum;  ///< check sum of the samples; empty where there are none
};

/// One line of results.jsonl or of a journal. Times, hosts and builds are left out. Throws std::exception on a line
/// that is not one.
RecordedCell read_recorded_cell(const std::string& line);

}  // namespace kreisel
