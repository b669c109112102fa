// SPDX-License-Identifier: BSD-3-Clause
#include "driver/plan/identify.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "records/json/writer.hpp"
#include "support/hash.hpp"

namespace kreisel {

namespace {

// Everything that determines the numbers, with keys and lists in a fixed order; not the label.
std::string content_of(const PlannedCell& planned) {
    const Cell& cell = planned.cell;
    std::vector<std::string> metrics = cell.metrics;
    std::sort(metrics.begin(), metrics.end());
    ObjectWriter object;
    object.member("problem", json_text(cell.problem))
        .member("parameters", json_value(cell.parameters))
        .member("formulation", json_text(cell.formulation))
        .member("method", json_text(cell.method))
        .member("options", json_value(cell.options))
        .member("projection", json_text(cell.projection))
        .member("projection_options", json_value(cell.projection_options))
        .member("precision", json_text(planned.precision))
        .member("t_end", json_number(cell.t_end))
        .member("steps", fmt::format("{}", cell.steps))
        .member("samples", fmt::format("{}", cell.samples))
        .member("metrics", json_value(metrics));
    if (cell.tolerance > 0) {
        object.member("tolerance", json_number(cell.tolerance)).member("controller", json_text(cell.controller));
        if (!cell.dense && cell.samples > 0) { object.member("dense", "false"); }
    }
    if (cell.timed) { object.member("timed", "true"); }
    if (cell.repeated) { object.member("repeated", "true"); }
    return object.text();
}

CellIdentity identity_of(const PlannedCell& planned, const Order& order) {
    const Cell& cell = planned.cell;
    return {planned.hash,
            cell.problem,
            planned.label,
            planned.series,
            parse_exactly(json_value(cell.parameters)),
            cell.formulation,
            cell.method,
            cell.options,
            order,
            cell.projection,
            cell.projection_options,
            planned.precision,
            cell.steps,
            cell.steps > 0 ? cell.t_end / static_cast<double>(cell.steps) : 0,
            cell.tolerance,
            cell.tolerance > 0 ? cell.controller : "",
            cell.t_end};
}

}  // namespace

void identify(PlannedCell& planned, const Order& order) {
    planned.hash = hash_text(content_of(planned));
    planned.identity = identity_of(planned, order);
}

}  // namespace kreisel
