// SPDX-License-Identifier: BSD-3-Clause
#include "problems/reading/bodies.hpp"

#include <set>

#include "problems/reading/parts.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

Body read_body(const BodyData& data, const std::string& path, std::vector<std::string>& warnings) {
    Body body{.name = to_name(data.name, path + "/name"), .mass = to_mass(data.mass, path + "/mass")};
    body.point = data.point;
    body.start.x = to_vec3(data.x);
    if (data.v) body.start.v = to_vec3(*data.v);
    if (data.point) return body;
    body.J = to_inertia(data.inertia, path + "/inertia", TriangleInequality::required, warnings);
    body.start.R = to_rotation(data.R, path + "/R");
    if (data.omega) body.start.omega = to_vec3(*data.omega);
    return body;
}

}  // namespace

void read_bodies(Model& model, const std::vector<BodyData>& bodies) {
    if (bodies.empty()) throw ParameterError("/bodies", "expected at least one body");
    std::set<std::string> names;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const std::string path = reading::place("bodies", i);
        model.bodies.push_back(read_body(bodies[i], path, model.warnings));
        if (!names.insert(bodies[i].name).second)
            throw ParameterError(path + "/name",
                                 "expected bodies with different names, got a second \"" + bodies[i].name + "\"");
    }
}

GivenVelocities given_velocities(const std::vector<BodyData>& bodies) {
    GivenVelocities given;
    for (const BodyData& body : bodies) {
        given.v.push_back(body.v.has_value());
        given.omega.push_back(body.point || body.omega.has_value());
    }
    return given;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
