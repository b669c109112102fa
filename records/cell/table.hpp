// SPDX-License-Identifier: BSD-3-Clause
//
// results.csv: a row for each cell, with units in the titles.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "records/cell/columns/column_group.hpp"
#include "records/cell/fields.hpp"
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
/// Lines are not kept: a row has the columns that there are when it is made, and once all lines have been rows there
/// are all columns.
class ResultsTable {
  public:
    explicit ResultsTable(TableUnits units);
    /// The row of a line of results.jsonl, with its end; adds the columns that it has and the table has not. Throws
    /// std::invalid_argument on a line that is not one.
    std::string row(std::string_view line);
    /// The line of titles, with its end.
    std::string header() const;
    std::size_t columns() const;

  private:
    struct Group {
        const RecordField* field;
        ColumnGroup columns = {};
    };

    TableUnits units_;
    std::vector<Group> groups_;
};

}  // namespace kreisel
