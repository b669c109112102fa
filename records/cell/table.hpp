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
    /// std::invalid_argument where a value is not one of a line.
    std::string row(const FieldValues& values);
    /// The line of titles, with its end.
    std::string header() const;
    std::size_t columns() const;

  private:
    /// Most values are those of the row before, and so are their columns.
    struct Group {
        std::size_t field;  ///< its place in record_fields
        ColumnGroup columns = {};
        std::string json = {}, texts = {};  ///< of the row before; each text with a comma behind it
    };
    void put(std::string_view json, const std::string& problem, Group& group) const;

    TableUnits units_;
    std::vector<Group> groups_;
    std::string problem_;  // of the row before
};

}  // namespace kreisel
