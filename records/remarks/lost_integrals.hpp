// SPDX-License-Identifier: BSD-3-Clause
//
// Notes of `run` and `table` on cells that succeeded but violate a first integral.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "records/results.hpp"

namespace kreisel {

/// A sentence for each problem (by label) in which a cell has lost more than 1 % of a first integral: the number of
/// cells, and the worst one. Cells that did not finish are not counted.
class LostIntegrals {
  public:
    void add(const ResultRow& row);
    std::vector<std::string> notes() const;

  private:
    struct Group {
        std::size_t ended = 0, lost = 0;
        double share = 0;        ///< the largest
        std::string worst = {};  ///< what there is to say of the cell that has lost it
    };
    std::map<std::string, Group> groups_;
};

/// The same of many.
std::vector<std::string> lost_integral_notes(const std::vector<ResultRow>& rows);

}  // namespace kreisel
