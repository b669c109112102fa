// SPDX-License-Identifier: BSD-3-Clause
#include "plots/report/forces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "records/json/lists.hpp"
#include "records/json/writer.hpp"
#include "records/reading/trajectory_table.hpp"
#include "support/base64.hpp"

namespace kreisel {

namespace {

using Columns = std::vector<const std::vector<double>*>;

// What has one of these names; empty where one is missing.
Columns columns_named(const TrajectoryTable& trajectory, const std::vector<std::string>& names) {
    Columns columns;
    for (const std::string& name : names) {
        const auto* column = trajectory.find(name);
        if (column == nullptr) { return {}; }
        columns.push_back(column);
    }
    return columns;
}

// A vector that a link exerts on its second body: of a joint its reaction.
Columns exerted_by(const TrajectoryTable& trajectory, const std::string& link, const char* part) {
    for (const char* what : {"reaction", "exerted"}) {
        std::vector<std::string> names;
        for (int k = 1; k <= 3; ++k) { names.push_back(fmt::format("{}.{}.{}.{}", what, link, part, k)); }
        Columns columns = columns_named(trajectory, names);
        if (!columns.empty()) { return columns; }
    }
    return {};
}

bool is_zero(const std::vector<double>& column) {
    return std::all_of(column.begin(), column.end(), [](double value) { return value == 0; });
}
bool are_zero(const Columns& columns) {
    return std::all_of(columns.begin(), columns.end(), [](const auto* column) { return is_zero(*column); });
}

std::string packed(const Columns& columns, const std::vector<std::size_t>& instants) {
    std::string bytes;
    for (const std::size_t k : instants) {
        for (const auto* column : columns) {
            const std::uint16_t half = half_of_float((*column)[k]);
            bytes += static_cast<char>(half & 0xffU);
            bytes += static_cast<char>(half >> 8U);
        }
    }
    return json_text(base64_text(bytes));
}

bool holds_one_of(const LinkGeometry& link, const std::vector<std::string>& bodies) {
    return std::any_of(link.between.begin(), link.between.end(), [&](const std::string& name) {
        return std::find(bodies.begin(), bodies.end(), name) != bodies.end();
    });
}

Vector3 vector_at(const JsonValue& object, const char* key) {
    const JsonValue* found = object.find(key);
    Vector3 v{};
    if (found == nullptr || found->elements.size() != v.size()) { return v; }
    for (std::size_t i = 0; i < v.size(); ++i) { v[i] = found->elements[i].number(); }
    return v;
}

// What swings: its amplitude and frequency, under keys that begin with `prefix`.
void add_swing(const JsonValue& object, const std::string& prefix, ObjectWriter& writer) {
    for (const char* key : {"amplitude", "frequency"}) {
        const JsonValue* found = object.find(prefix + key);
        writer.member(key, json_number(found == nullptr ? 0 : found->number()));
    }
}

double first_of(const TrajectoryTable& trajectory, const std::string& name) {
    const auto* column = trajectory.find(name);
    return column == nullptr || column->empty() ? 0 : column->front();
}

// R^T (p - x) at the first sample.
Vector3 in_body_axes(const Vector3& point, const std::string& body, const TrajectoryTable& trajectory) {
    Vector3 result{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            const double away = point[k] - first_of(trajectory, fmt::format("{}.x{}", body, k + 1));
            result[i] += first_of(trajectory, fmt::format("{}.R{}{}", body, k + 1, i + 1)) * away;
        }
    }
    return result;
}

// Of a force or a torque on a body; empty for other entries.
std::string load_json(const JsonValue& entry, const TrajectoryTable& trajectory) {
    const std::string type = entry.at("type").string();
    if (type != "force" && type != "torque") { return ""; }
    const std::string body = entry.at("body").string();
    const Vector3 value = vector_at(entry, "value");
    const bool has_point = type == "force" && entry.find("point") != nullptr;
    const Vector3 point = has_point ? in_body_axes(vector_at(entry, "point"), body, trajectory) : Vector3{};
    ObjectWriter load;
    load.member("body", json_text(body))
        .member("force", json_list(type == "force" ? value : Vector3{}, json_number))
        .member("torque", json_list(type == "torque" ? value : Vector3{}, json_number))
        .member("point", json_list(point, json_number))
        .member("frame", json_text(entry.at("frame").string()));
    add_swing(entry, "", load);
    return load.text();
}

}  // namespace

std::uint16_t half_of_float(double value) {
    constexpr std::uint16_t not_a_number = 0x7fc0;
    if (!(std::abs(value) < 1e38)) { return not_a_number; }
    const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(value));
    return static_cast<std::uint16_t>((bits + 0x7fffU + ((bits >> 16U) & 1U)) >> 16U);
}

std::size_t bytes_of_forces(const TrajectoryTable& trajectory) {
    std::size_t numbers = 0;
    for (std::size_t i = 0; i < trajectory.names.size(); ++i) {
        const std::string& name = trajectory.names[i];
        const bool of_link =
            name.starts_with("drive.") || name.starts_with("reaction.") || name.starts_with("exerted.");
        numbers += of_link && !name.ends_with(".unique") && !is_zero(trajectory.columns[i]) ? 1U : 0U;
    }
    return numbers * sizeof(std::uint16_t) * 4 / 3;
}

std::string forces_json(const TrajectoryTable& trajectory, const Geometry& mechanism,
                        const std::vector<std::string>& bodies, const std::vector<std::size_t>& instants) {
    std::vector<std::string> links;
    for (std::size_t i = 0; i < mechanism.links.size(); ++i) {
        const LinkGeometry& link = mechanism.links[i];
        const Columns force = exerted_by(trajectory, link.name, "force"),
                      torque = exerted_by(trajectory, link.name, "torque");
        if ((force.empty() && torque.empty()) || !holds_one_of(link, bodies)) { continue; }
        ObjectWriter exerted;
        exerted.member("link", std::to_string(i));
        if (!are_zero(force)) { exerted.member("F", packed(force, instants)); }
        if (!are_zero(torque)) { exerted.member("tau", packed(torque, instants)); }
        for (const char* drive : {"force", "torque"}) {
            const Columns driving = columns_named(trajectory, {fmt::format("drive.{}.{}", link.name, drive)});
            if (!driving.empty()) { exerted.member(drive, packed(driving, instants)); }
        }
        links.push_back(exerted.text());
    }
    return json_list(links, [](const std::string& link) { return link; });
}

std::string applied_json(const JsonValue& parameters, const TrajectoryTable& trajectory) {
    ObjectWriter gravity;
    gravity.member("g", json_list(vector_at(parameters, "gravity"), json_number));
    add_swing(parameters, "gravity_", gravity);
    std::vector<std::string> loads;
    const JsonValue* forces = parameters.find("forces");
    for (const JsonValue& entry : forces == nullptr ? std::vector<JsonValue>() : forces->elements) {
        const std::string load = load_json(entry, trajectory);
        if (!load.empty()) { loads.push_back(load); }
    }
    return ObjectWriter()
        .member("gravity", gravity.text())
        .member("loads", json_list(loads, [](const std::string& load) { return load; }))
        .text();
}

}  // namespace kreisel
