// SPDX-License-Identifier: BSD-3-Clause
#include "records/geometry.hpp"

#include <algorithm>
#include <stdexcept>

#include "records/json/exact.hpp"
#include "records/json/lists.hpp"
#include "records/json/writer.hpp"
#include "records/sums/sum_list.hpp"
#include "support/files.hpp"
#include "support/sha256.hpp"

namespace kreisel {

namespace {

std::string vector_json(const Vector3& v) { return json_list(v, json_number); }

std::string body_json(const BodyGeometry& body, const Shapes& shapes) {
    ObjectWriter object;
    object.member("name", json_text(body.name)).member("mass", json_number(body.mass));
    object.member("inertia", json_rows(body.inertia, json_number));
    if (const auto shape = shapes.find(body.name); shape != shapes.end()) {
        object.member(shape_key, json_shape(shape->second));
    }
    return object.text();
}

std::string link_json(const LinkGeometry& link) {
    ObjectWriter object;
    object.member("name", json_text(link.name))
        .member("type", json_text(link.type))
        .member("between", json_list(link.between, [](const std::string& name) { return json_text(name); }))
        .member("points", json_list(link.points, vector_json));
    if (!link.axes.empty()) { object.member("axes", json_list(link.axes, vector_json)); }
    if (link.length != 0) { object.member("length", json_number(link.length)); }
    return object.text();
}

std::string mechanism_json(const CellGeometry& mechanism) {
    const auto write_body = [&](const BodyGeometry& body) { return body_json(body, mechanism.shapes); };
    return ObjectWriter()
        .member("cells", json_value(mechanism.cells))
        .member("bodies", json_list(mechanism.geometry.bodies, write_body))
        .member("links", json_list(mechanism.geometry.links, link_json))
        .text();
}

Vector3 vector_of(const JsonValue& json) {
    if (json.elements.size() != 3) { throw std::invalid_argument("expected three numbers"); }
    return {json.elements[0].number(), json.elements[1].number(), json.elements[2].number()};
}

BodyGeometry body_of_json(const JsonValue& json) {
    BodyGeometry body{json.at("name").string(), json.at("mass").number()};
    const JsonValue& rows = json.at("inertia");
    if (rows.elements.size() != 3) { throw std::invalid_argument("expected three rows"); }
    for (std::size_t i = 0; i < 3; ++i) {
        const Vector3 row = vector_of(rows.elements[i]);
        std::copy(row.begin(), row.end(), body.inertia.begin() + static_cast<std::ptrdiff_t>(3 * i));
    }
    return body;
}

LinkGeometry link_of_json(const JsonValue& json) {
    LinkGeometry link{json.at("name").string(), json.at("type").string()};
    const auto& between = json.at("between").elements;
    const auto& points = json.at("points").elements;
    if (between.size() != 2 || points.size() != 2) { throw std::invalid_argument("expected two bodies and points"); }
    for (std::size_t i = 0; i < 2; ++i) {
        link.between[i] = between[i].string();
        link.points[i] = vector_of(points[i]);
    }
    if (const JsonValue* axes = json.find("axes")) {
        for (const JsonValue& axis : axes->elements) { link.axes.push_back(vector_of(axis)); }
    }
    if (const JsonValue* length = json.find("length")) { link.length = length->number(); }
    return link;
}

CellGeometry mechanism_of_json(const JsonValue& json) {
    CellGeometry mechanism;
    for (const JsonValue& cell : json.at("cells").elements) { mechanism.cells.push_back(cell.string()); }
    for (const JsonValue& body : json.at("bodies").elements) {
        mechanism.geometry.bodies.push_back(body_of_json(body));
        if (const JsonValue* shape = body.find(shape_key)) {
            mechanism.shapes.emplace(mechanism.geometry.bodies.back().name, shape_of_json(*shape));
        }
    }
    for (const JsonValue& link : json.at("links").elements) { mechanism.geometry.links.push_back(link_of_json(link)); }
    return mechanism;
}

// The text of a file that is what its sum says; empty for any other.
std::string summed_geometry(const std::filesystem::path& folder) {
    std::error_code error;
    const auto file = folder / geometry_file;
    if (!std::filesystem::is_regular_file(file, error)) { return ""; }
    const SumList list = read_sum_list(folder);
    const auto sum = list.sums.find(geometry_file);
    std::string text = read_text(file);
    return sum != list.sums.end() && sum->second == sha256_text(text) ? text : "";
}

}  // namespace

std::string geometry_text(const std::vector<CellGeometry>& mechanisms) {
    return ObjectWriter().member("mechanisms", json_list(mechanisms, mechanism_json)).text() + "\n";
}

void write_geometry(const std::filesystem::path& folder, const std::vector<CellGeometry>& mechanisms) {
    announce_files(folder, {geometry_file});
    write_atomically(folder / geometry_file, geometry_text(mechanisms));
    record_sums(folder, {geometry_file});
}

std::vector<CellGeometry> read_geometry(const std::filesystem::path& folder) {
    const std::string text = summed_geometry(folder);
    std::vector<CellGeometry> mechanisms;
    if (text.empty()) { return mechanisms; }
    try {
        const JsonValue json = parse_exactly(text);
        for (const JsonValue& one : json.at("mechanisms").elements) { mechanisms.push_back(mechanism_of_json(one)); }
    } catch (const std::invalid_argument&) { return {}; }  // intact, but of another format
    return mechanisms;
}

const CellGeometry* geometry_of(const std::vector<CellGeometry>& mechanisms, const std::string& cell) {
    for (const CellGeometry& mechanism : mechanisms) {
        const auto& cells = mechanism.cells;
        if (std::find(cells.begin(), cells.end(), cell) != cells.end()) { return &mechanism; }
    }
    return nullptr;
}

}  // namespace kreisel
