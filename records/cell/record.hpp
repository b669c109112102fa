// SPDX-License-Identifier: BSD-3-Clause
//
// What results say of one cell: what was run, how it ended, what it cost. Files are written and read by one table of
// their members (fields.hpp).
#pragma once

#include <optional>
#include <string>

#include "engine/engine.hpp"
#include "records/cell/statuses.hpp"
#include "records/json/exact.hpp"

namespace kreisel {

/// Whether text read from a file names a cell: such names become paths.
inline bool is_cell_name(const std::string& text) {
    return !text.empty() && text.find_first_not_of("0123456789abcdefABCDEF") == std::string::npos;
}

/// Path of a cell's trajectory below the results folder.
inline std::string trajectory_file(const std::string& hash) { return "trajectories/" + hash + ".csv"; }

/// What was run. Empty or zero: not told (lines of older versions).
struct CellIdentity {
    std::string cell;  ///< hash, 16 hexadecimal digits, over all that determines the numbers
    std::string problem, label;
    std::string series;             ///< of the label, where a parameter varies; else the label
    std::string parameters = "{}";  ///< JSON
    std::string formulation, method;
    OptionValues options;
    std::optional<Order> order;  ///< as the method declares it
    std::string projection;
    OptionValues projection_options;
    std::string precision;
    long steps = 0;  ///< of one size; 0 where they are chosen to a tolerance
    double h = 0;    ///< s; of steps of one size
    double tolerance = 0;
    std::string controller;  ///< of steps to a tolerance
    double t_begin = 0;      ///< s; 0: the start of the problem
    double t_end = 0;        ///< s

    bool quad() const { return precision == "quad"; }
    bool operator==(const CellIdentity&) const = default;
};

/// What is known of the reference a cell was compared with, rounded to double.
struct ReferenceNote {
    std::map<std::string, double> error;  ///< bounds, by error.* metric
    double horizon = 0;                   ///< s
    bool past_horizon = false;            ///< the cell ends later
};

/// How it ended: the same on every run of one build.
struct CellOutcome {
    std::string status, detail;
    long steps_done = 0;   ///< of a failed cell
    double t_reached = 0;  ///< of a failed cell, s
    int bodies = 0;        ///< of a timed cell; 0: not told
    std::optional<ReportedState> final;
    ConstraintSummary constraints;
    std::vector<std::pair<std::string, Number>> metrics;
    std::map<std::string, std::string> unmeasured;  ///< metrics that are not defined, and why
    std::optional<LostIntegral> lost;
    std::optional<ReferenceNote> reference;
    std::string trajectory, trajectory_sum;  ///< file below the results folder, check sum; empty where there is none
    std::vector<std::pair<std::string, Number>> counts;  ///< of the cost, "evaluations" and others

    bool failed() const { return status != kreisel::status::ok && status != kreisel::status::skipped; }
};

/// What differs from run to run; in journals only.
struct CellTimes {
    double cpu_s = 0;
    std::optional<double> step_s, memory;  ///< of a timed cell: s, bytes
    std::optional<double> run_s;           ///< all steps of a repeated cell, s
};

struct CellRecord {
    CellIdentity identity;
    CellOutcome outcome;
    CellTimes times;
};

}  // namespace kreisel
