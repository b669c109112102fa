// SPDX-License-Identifier: BSD-3-Clause
#include "driver/plan/cells/identify.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "records/begin.hpp"
#include "records/json/writer.hpp"
#include "support/hash.hpp"

namespace kreisel {

CellIdentity identity_of(const Cell& cell, const std::string& series, const std::string& precision,
                         const Order& order) {
    CellIdentity identity;
    identity.problem = cell.problem;
    identity.series = series;
    identity.formulation = cell.formulation;
    identity.method = cell.method;
    identity.options = cell.options;
    identity.order = order;
    identity.projection = cell.projection;
    identity.projection_options = cell.projection_options;
    identity.precision = precision;
    identity.t_begin = cell.t_begin();
    identity.t_end = cell.t_end;
    return identity;
}

// The text that is hashed is one object, with keys and lists in a fixed order:
// {...,"t_end":1,"steps":100,"samples":0,"metrics":[...]} for steps of one size.
CellNaming::CellNaming(const PlannedRun& run) {
    const Cell& cell = run.cell;
    before_parameters_ = hash64("{\"problem\":" + json_text(cell.problem) + ",\"parameters\":");
    ObjectWriter after;
    after.member("formulation", json_text(cell.formulation))
        .member("method", json_text(cell.method))
        .member("options", json_value(cell.options))
        .member("projection", json_text(cell.projection))
        .member("projection_options", json_value(cell.projection_options))
        .member("precision", json_text(run.identity.precision));
    if (cell.begin) { after.member("begin", json_begin(*cell.begin)); }
    after.member("t_end", json_number(cell.t_end));
    before_steps_ = "," + after.open_text().substr(1) + ",\"steps\":";
    std::vector<std::string> metrics = cell.metrics;
    std::sort(metrics.begin(), metrics.end());
    after_steps_ = fmt::format(",\"samples\":{},\"metrics\":{}", cell.samples, json_value(metrics));
    of_tolerance_ = ",\"controller\":" + json_text(cell.controller);
    if (!cell.dense && cell.samples > 0) { of_tolerance_ += ",\"dense\":false"; }
    if (cell.timed) { of_times_ += ",\"timed\":true"; }
    if (cell.repeated) { of_times_ += ",\"repeated\":true"; }
    of_times_ += "}";
}

std::uint64_t CellNaming::name(const std::string& parameters, long steps, double tolerance) const {
    std::uint64_t hash = hash64(parameters, before_parameters_);
    hash = hash64(std::to_string(steps), hash64(before_steps_, hash));
    hash = hash64(after_steps_, hash);
    if (tolerance > 0) { hash = hash64(",\"tolerance\":" + json_number(tolerance) + of_tolerance_, hash); }
    return hash64(of_times_, hash);
}

}  // namespace kreisel
