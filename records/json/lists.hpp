// SPDX-License-Identifier: BSD-3-Clause
//
// Lists and matrices as JSON. Internal to the writer.
#pragma once

#include <array>
#include <string>

namespace kreisel {

/// `append` adds a value to a text.
template <class Range, class Append>
void append_list(std::string& json, const Range& values, const Append& append) {
    json += '[';
    bool first = true;
    for (const auto& value : values) {
        if (!first) { json += ','; }
        first = false;
        append(json, value);
    }
    json += ']';
}

template <class Value, class Append>
void append_rows(std::string& json, const std::array<Value, 9>& m, const Append& append) {
    for (std::size_t i = 0; i < m.size(); ++i) {
        json += i % 3 != 0 ? "," : i == 0 ? "[[" : "],[";
        append(json, m[i]);
    }
    json += "]]";
}

template <class Range, class Write>
std::string json_list(const Range& values, const Write& write) {
    std::string text;
    append_list(text, values, [&](std::string& json, const auto& value) { json += write(value); });
    return text;
}

template <class Value, class Write>
std::string json_rows(const std::array<Value, 9>& m, const Write& write) {
    std::string text;
    append_rows(text, m, [&](std::string& json, const Value& value) { json += write(value); });
    return text;
}

}  // namespace kreisel
