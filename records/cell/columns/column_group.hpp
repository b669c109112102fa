// SPDX-License-Identifier: BSD-3-Clause
//
// The columns of results.csv that one field of a record has: one for "status", one for each parameter.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace kreisel {

/// Columns in the order of first appearance, and what the row at hand has in them.
class ColumnGroup {
  public:
    /// All columns become empty.
    void begin_row();
    /// The text of a column, which is added where it is new.
    void put(std::string_view title, std::string_view text);

    const std::vector<std::string>& titles() const { return titles_; }
    const std::vector<std::string>& texts() const { return texts_; }

  private:
    std::size_t place_of(std::string_view title);

    std::vector<std::string> titles_, texts_;
    std::map<std::string, std::size_t, std::less<>> places_;  // of the titles
    std::size_t next_ = 0;                                    // of a row with the columns of the one before
};

}  // namespace kreisel
