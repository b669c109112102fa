// SPDX-License-Identifier: BSD-3-Clause
#include "records/cell/statuses.hpp"

#include <algorithm>
#include <iterator>

namespace kreisel::status {

const Entry* find(std::string_view status) {
    const std::string_view name = status.substr(0, status.find('('));
    const auto* entry = std::find_if(std::begin(table), std::end(table), [&](const Entry& one) {
        return name == one.name && one.has_reason == (name.size() < status.size());
    });
    return entry == std::end(table) ? nullptr : entry;
}

}  // namespace kreisel::status
