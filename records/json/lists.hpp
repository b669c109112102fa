// SPDX-License-Identifier: BSD-3-Clause
//
// Lists and matrices as JSON. Internal to the writer.
#pragma once

#include <array>
#include <string>

namespace kreisel {

template <class Range, class Write>
std::string json_list(const Range& values, const Write& write) {
    std::string text = "[";
    for (const auto& value : values) {
        if (text.size() > 1) { text += ','; }
        text += write(value);
    }
    text += ']';
    return text;
}

template <class Value, class Write>
std::string json_rows(const std::array<Value, 9>& m, const Write& write) {
    std::string text = "[";
    for (std::size_t i = 0; i < m.size(); ++i) {
        text += i % 3 != 0 ? "," : i == 0 ? "[" : "],[";
        text += write(m[i]);
    }
    text += "]]";
    return text;
}

}  // namespace kreisel
