// SPDX-License-Identifier: BSD-3-Clause
#include "driver/config/schema/figures.hpp"

#include <nlohmann/json.hpp>

#include "driver/config/reading/figure_demands.hpp"

namespace kreisel::schema {

namespace {

Schema with_key(const char* key, const Schema& value) { return {{"properties", {{key, value}}}}; }

Schema requiring(const char* key, const Schema& value) {
    Schema schema = with_key(key, value);
    schema["required"] = {key};
    return schema;
}

Schema has(const char* key) { return {{"required", Schema::array({key})}}; }

// A config that provides it.
Schema providing(Provision what) {
    const Schema tolerances = with_key("time", has("tolerance"));
    const Schema repeated = with_key("kind", {{"enum", repeated_kinds()}});
    switch (what) {
        case Provision::timed:
            return with_key("kind", {{"enum", timed_kinds()}});
        case Provision::not_timed:
            return with_key("kind", {{"not", {{"enum", timed_kinds()}}}});
        case Provision::samples:
            return requiring("output", requiring("samples", {{"minimum", 1}}));
        case Provision::repeated:
            return repeated;
        case Provision::counted:
            return {{"anyOf", {repeated, tolerances}}};
        case Provision::tolerances:
            return tolerances;
        case Provision::constant_steps:
            return with_key("time", {{"anyOf", {has("steps"), has("step")}}});
    }
    return {};
}

// A config one of whose figures demands it.
Schema demanding(const FigureDemand& demand) {
    Schema figure = requiring("kind", {{"enum", demand.kinds}});
    figure["type"] = "object";
    if (!demand.x.empty()) {
        figure["properties"]["x"] = {{"enum", demand.x}};
        figure["required"].push_back("x");
    }
    const Schema some = {{"type", "array"}, {"contains", figure}};
    return requiring("figure", {{"anyOf", {figure, some}}});
}

}  // namespace

Schema demands_of_figures() {
    Schema all = Schema::array();
    for (const FigureDemand& demand : figure_demands()) {
        all.push_back({{"anyOf", Schema::array({{{"not", demanding(demand)}}, providing(demand.needs)})}});
    }
    return all;
}

}  // namespace kreisel::schema
