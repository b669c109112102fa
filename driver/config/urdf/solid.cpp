// SPDX-License-Identifier: BSD-3-Clause
#include "driver/config/urdf/solid.hpp"

#include <algorithm>
#include <cmath>

namespace kreisel::urdf {

namespace {

using nlohmann::json;

std::optional<Solid> solid_of(const Element& drawn) {
    const auto geometry = drawn.child("geometry");
    if (!geometry) { return std::nullopt; }
    Solid solid{"", {0, 0, 0}, read_origin(drawn)};
    if (const auto box = geometry->child("box")) {
        solid.type = "box";
        solid.sizes = to_vector(box->vector("size", {0, 0, 0}));
    } else if (const auto cylinder = geometry->child("cylinder")) {
        const double diameter = 2 * cylinder->required_number("radius");
        solid.type = "cylinder";
        solid.sizes = {diameter, diameter, cylinder->required_number("length")};
    } else if (const auto sphere = geometry->child("sphere")) {
        const double diameter = 2 * sphere->required_number("radius");
        solid.type = "sphere";
        solid.sizes = {diameter, diameter, diameter};
    }
    const bool extends = std::all_of(solid.sizes.a, solid.sizes.a + 3, [](double size) {
        return size > 0 && std::isfinite(size);  // of doubled radii
    });
    return extends ? std::optional<Solid>(solid) : std::nullopt;
}

// Edges along the axes of the link; null where the edges of the box are not along these.
json edges_of(const Solid& box) {
    constexpr double hardly_seen = 0.01;  // rad: right angles are written as 1.57, too
    json edges = json::array();
    for (const auto& row : box.frame.R.a) {
        double edge = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const double along = std::abs(row[k]);
            if (along > hardly_seen && along < 1 - hardly_seen) { return {}; }
            edge += along > 0.5 ? box.sizes.a[k] : 0;
        }
        edges.push_back(edge);
    }
    return edges;
}

}  // namespace

std::optional<Solid> read_solid(const Element& link) {
    for (const char* tag : {"visual", "collision"}) {
        for (const Element& drawn : link.children()) {
            if (drawn.tag() != tag) { continue; }
            if (auto solid = solid_of(drawn)) { return solid; }
        }
    }
    return std::nullopt;
}

json shape_about(const Solid& solid, const Vector& centre) {
    constexpr double near = 0.05;  // of the size: hardly seen
    const double size = *std::max_element(solid.sizes.a, solid.sizes.a + 3);
    if (boost::qvm::mag(solid.frame.p - centre) > near * size) { return {}; }
    const double radius = solid.sizes.a[0] / 2;
    if (solid.type == "sphere") { return {{"type", "sphere"}, {"radius", radius}}; }
    if (solid.type == "cylinder") {
        const auto& R = solid.frame.R.a;
        return {{"type", "cylinder"},
                {"radius", radius},
                {"length", solid.sizes.a[2]},
                {"axis", {R[0][2], R[1][2], R[2][2]}}};
    }
    json edges = edges_of(solid);
    return edges.is_null() ? json() : json{{"type", "box"}, {"size", std::move(edges)}};
}

}  // namespace kreisel::urdf
