// SPDX-License-Identifier: BSD-3-Clause
//
// Tables by their names.
#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>

#include "plots/tables/table.hpp"

namespace kreisel::test {

inline std::vector<TablePair> tables_named(const std::string& name, const Results& results) {
    for (const ResultTable& table : result_tables()) {
        if (table.name == name) { return table.make(results); }
    }
    throw std::invalid_argument("no table " + name);
}

}  // namespace kreisel::test
