// SPDX-License-Identifier: BSD-3-Clause
//
// The results of a run as tables and figures need them: numbers rounded to double, damage reported and skipped.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "records/cell/record.hpp"
#include "records/metrics/units.hpp"
#include "records/rows/named_numbers.hpp"
#include "records/rows/shared.hpp"

namespace kreisel {

/// One cell. Numbers of quad cells are rounded to double: enough for tables, slopes and drawings. All rows of a run are
/// held at once: what many have alike is shared.
struct ResultRow {
    std::string cell, problem, series, label, formulation, method, projection, precision, status, detail;
    Shared<std::map<std::string, std::string>> options, projection_options;
    Shared<std::string> parameters = std::string("{}");  ///< JSON, canonical for each value
    long steps = 0;                                      ///< of one size; 0 where they are chosen to a tolerance
    long bodies = 0;                                     ///< 0 if the line does not have it
    double h = 0, tolerance = 0, t_end = 0;
    std::string controller;  ///< of steps to a tolerance
    double t_reached = 0;    ///< of a failed cell, s
    NamedNumbers metrics;
    Shared<std::map<std::string, std::string>> digits;      ///< of the metrics of a quad cell, as written
    Shared<std::map<std::string, std::string>> unmeasured;  ///< metrics that are not defined, and why
    NamedNumbers reference_error;                           ///< by error.* metric; empty without a reference
    double reference_horizon = 0;                           ///< s; 0 without a reference
    std::string lost_integral;                              ///< changed by more than 1 % of its terms; empty: none was
    double lost_share = 0;                                  ///< by how much
    bool past_horizon = false;                              ///< it ends past that: errors are accurate to 1 % only
    NamedNumbers scale;                                     ///< by error.* metric: size of the final state, same unit
    NamedNumbers cost;                                      ///< counts; from the journals "step_s", "memory", "run_s"
    Shared<std::map<std::string, int>> declared_order;      ///< by error.* metric; empty where the method declares none
    bool has_trajectory = false;
    std::string trajectory_sum;            ///< of its samples; empty: not told
    Shared<std::filesystem::path> folder;  ///< of the results that it was read from
    std::string results;                   ///< what these are called beside others; empty: alone

    bool ok() const { return status == "ok"; }
    bool adaptive() const { return tolerance > 0; }
};

struct Results {
    std::vector<ResultRow> rows;
    std::vector<ResultRow> missing;   ///< planned cells without a result, in the order of the plan
    std::vector<std::string> damage;  ///< a text for each damaged line or file, which is left out
    std::string warning;              ///< that the folder is of an older format; empty otherwise
    std::string config;               ///< as resolved, JSON; empty where there is no manifest
    std::string kind;                 ///< of the experiment; empty where there is no manifest
    std::string name;                 ///< of the experiment
    Units units;                      ///< of the metrics, as far as the manifest or older names tell
};

/// "2 of 12 cells missing, 1 failed, 3 damages left out" for figures; empty where there is nothing to say.
std::string what_is_wanting(const Results& results);

/// A record with its numbers rounded.
ResultRow result_row(const CellRecord& record);

/// One line of results.jsonl, whatever its sum. Throws std::exception on a line that is not one.
ResultRow read_result_line(const std::string& line);

}  // namespace kreisel
