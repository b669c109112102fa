// SPDX-License-Identifier: BSD-3-Clause
#include "engine/report/geometry.hpp"

#include "engine/report/exerted_forces.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

Vector3 rounded(const Vec3& v) {
    return {static_cast<double>(v(0)), static_cast<double>(v(1)), static_cast<double>(v(2))};
}

BodyGeometry geometry_of_body(const Body& body) {
    BodyGeometry geometry{body.name, static_cast<double>(body.mass)};
    for (std::size_t i = 0; i < 9 && !body.point; ++i)
        geometry.inertia[i] = static_cast<double>(body.J(static_cast<int>(i / 3), static_cast<int>(i % 3)));
    return geometry;
}

LinkGeometry geometry_of_joint(const Joint& joint, const std::string& name, const Model& model) {
    LinkGeometry link{name,
                      joint.type.name(),
                      {model.name_of(joint.first), model.name_of(joint.second)},
                      {rounded(joint.r_first), rounded(joint.r_second)}};
    if (joint.type->axes != JointAxes::none)
        link.axes = {rounded(joint.axes_first.col(2)), rounded(joint.axes_second.col(2))};
    link.length = static_cast<double>(joint.length);
    return link;
}

template <class Force>
LinkGeometry link_of(const Force& force, const std::string& name, const Model& model) {
    LinkGeometry link{name, force.type, {model.name_of(force.first), model.name_of(force.second)}};
    if constexpr (requires { force.r_first; }) link.points[0] = rounded(force.r_first);
    if constexpr (requires { force.r_second; }) link.points[1] = rounded(force.r_second);
    return link;
}

}  // namespace

Geometry to_geometry(const Model& model) {
    Geometry geometry;
    for (const Body& body : model.bodies) geometry.bodies.push_back(geometry_of_body(body));
    const std::vector<std::string> names = model.joint_names();
    for (std::size_t i = 0; i < model.joints.size(); ++i)
        geometry.links.push_back(geometry_of_joint(model.joints[i], names[i], model));
    const std::vector<std::string> forces = names_of_forces(model);
    std::size_t next = 0;
    each_force_between(model, [&](const auto& force, std::size_t) {
        geometry.links.push_back(link_of(force, forces[next++], model));
    });
    return geometry;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
