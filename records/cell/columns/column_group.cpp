// SPDX-License-Identifier: BSD-3-Clause
#include "records/cell/columns/column_group.hpp"

namespace kreisel {

void ColumnGroup::begin_row() {
    for (std::string& text : texts_) { text.clear(); }
    next_ = 0;
}

std::size_t ColumnGroup::place_of(std::string_view title) {
    if (next_ < titles_.size() && titles_[next_] == title) { return next_; }
    if (const auto known = places_.find(title); known != places_.end()) { return known->second; }
    places_.emplace(std::string(title), titles_.size());
    titles_.emplace_back(title);
    texts_.emplace_back();
    return titles_.size() - 1;
}

void ColumnGroup::put(std::string_view title, std::string_view text) {
    const std::size_t place = place_of(title);
    texts_[place] = text;
    next_ = place + 1;
}

}  // namespace kreisel
