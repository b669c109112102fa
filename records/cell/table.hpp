// SPDX-License-Identifier: BSD-3-Clause
//
// results.csv: a row for each cell, with units in the titles.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "records/cell/fields.hpp"
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
/// Records are not kept: a row has the columns that there are when it is made, and once all records have been rows there
/// are all columns.
class ResultsTable {
  public:
    explicit ResultsTable(TableUnits units);
    /// The line of a record, with its end; adds the columns that it has and the table has not.
    std::string row(const CellRecord& record);
    /// The line of titles, with its end.
    std::string header() const;
    std::size_t columns() const { return columns_; }

  private:
    struct Group {
        const RecordField* field;
        std::map<std::string, std::size_t> places = {};  // of the titles
        std::vector<std::string> titles = {};
    };
    /// `expected`: where it is if the record has the columns of the one before.
    std::size_t place_of(Group& group, const std::string& title, std::size_t expected);

    TableUnits units_;
    std::vector<Group> groups_;
    std::size_t columns_ = 0;
};

}  // namespace kreisel
