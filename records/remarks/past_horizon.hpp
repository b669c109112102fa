// SPDX-License-Identifier: BSD-3-Clause
//
// Notes of `run` and `table` on cells that end past the horizon of their reference.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "records/results.hpp"

namespace kreisel {

/// A sentence for each problem (by label) and end time past the horizon: the cells, T*, and the accuracy of the
/// reference there. Cells that did not finish are not counted.
class PastHorizon {
  public:
    void add(const ResultRow& row);
    std::vector<std::string> notes() const;

  private:
    struct Group {
        ResultRow first;
        std::size_t cells = 0;
    };
    std::map<std::pair<std::string, double>, Group> groups_;  // by label and end
};

/// The same of many.
std::vector<std::string> past_horizon_notes(const std::vector<ResultRow>& rows);

}  // namespace kreisel
