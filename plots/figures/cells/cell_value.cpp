// SPDX-License-Identifier: BSD-3-Clause
#include "plots/figures/cells/cell_value.hpp"

#include <algorithm>

namespace kreisel {

const std::vector<std::string>& cell_value_families() {
    static const std::vector<std::string> families = {"parameter.", "option.", "projection_option."};
    return families;
}

bool is_cell_value(const std::string& key) {
    const auto& families = cell_value_families();
    return std::any_of(families.begin(), families.end(),
                       [&](const std::string& family) { return key.starts_with(family) && key != family; });
}

std::string cell_value_text(const JsonValue& value) { return value.is_text() ? value.text : canonical_json(value); }

std::optional<std::string> cell_value(const ResultRow& row, const std::string& key) {
    const std::string name = key.substr(key.find('.') + 1);
    if (key.starts_with("parameter.")) {
        const JsonValue parameters = parse_exactly(*row.parameters);
        const JsonValue* value = parameters.find(name);
        return value == nullptr ? std::nullopt : std::optional(cell_value_text(*value));
    }
    const auto& options = key.starts_with("option.") ? row.options : row.projection_options;
    const auto value = options->find(name);
    return value == options->end() ? std::nullopt : std::optional(value->second);
}

}  // namespace kreisel
