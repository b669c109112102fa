// SPDX-License-Identifier: BSD-3-Clause
//
// Lists and matrices as JSON. Internal to the writer.
#pragma once

#include <array>
#include <string>

namespace kreisel {

template <class Range, class Write>
std::string json_list(const Range& values, const Write& write) {
    std::string text;
    for (const auto& value : values) { text += (text.empty() ? "" : ",") + write(value); }
    return "[" + text + "]";
}

template <class Value, class Write>
std::string json_rows(const std::array<Value, 9>& m, const Write& write) {
    std::string text;
    for (std::size_t row = 0; row < 3; ++row) {
        const std::array<Value, 3> values = {m[3 * row], m[3 * row + 1], m[3 * row + 2]};
        text += (row == 0 ? "" : ",") + json_list(values, write);
    }
    return "[" + text + "]";
}

}  // namespace kreisel
