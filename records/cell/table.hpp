// SPDX-License-Identifier: BSD-3-Clause
//
// results.csv: a row for each cell, with units in the titles.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "records/cell/record.hpp"
#include "records/metrics/units.hpp"

namespace kreisel {

/// Final states of larger mechanisms are in JSON lines only.
inline constexpr std::size_t most_bodies_in_table = 16;

struct TableUnits {
    Units metrics;
    std::map<std::string, Units> parameters;  ///< by problem and parameter
};

/// Columns by record_fields, the final state last; those of one group ("parameter.mass [kg]", "option.coordinates",
/// "error.position [m]", "final.rod.x.1 [m]") in the order of first appearance. Each number has the digits of the line.
std::string results_table(const std::vector<CellRecord>& records, const TableUnits& units);

}  // namespace kreisel
