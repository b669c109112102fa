// SPDX-License-Identifier: BSD-3-Clause
#include "plots/figures/schema.hpp"

#include <nlohmann/json.hpp>

#include "plots/figures/kind.hpp"

namespace kreisel {

namespace {

nlohmann::ordered_json schema_of(const FigureKey& key, const Figure& standard) {
    nlohmann::ordered_json schema = key.schema();
    schema["description"] = key.meaning + (key.absent.empty() ? "" : "; default: " + key.absent);
    const nlohmann::ordered_json value = key.value(standard);
    if (!value.is_null()) { schema["default"] = value; }
    return schema;
}

nlohmann::ordered_json schema_of(const FigureKind& kind) {
    const auto standard = kind.make();
    nlohmann::ordered_json properties = {{"kind", {{"const", kind.name}}}};
    for (const auto& keys : {common_figure_keys(), kind.keys}) {
        for (const FigureKey& key : keys) { properties[key.name] = schema_of(key, *standard); }
    }
    return {{"type", "object"},
            {"properties", properties},
            {"additionalProperties", false},
            {"required", {"kind"}},
            {"description", kind.summary}};
}

}  // namespace

nlohmann::ordered_json figure_schema() {
    nlohmann::ordered_json alternatives = nlohmann::ordered_json::array();
    for (const FigureKind& kind : figure_kinds()) { alternatives.push_back(schema_of(kind)); }
    return {{"anyOf", alternatives}};
}

}  // namespace kreisel
