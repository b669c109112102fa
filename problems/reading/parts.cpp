// SPDX-License-Identifier: BSD-3-Clause
#include "problems/reading/parts.hpp"

#include <sstream>

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace reading {

std::string text(const Real& x) {
    std::ostringstream out;
    out.precision(10);
    out << to_double(x);
    return out.str();
}

std::string place(const char* list, std::size_t entry) { return std::string("/") + list + "/" + std::to_string(entry); }

NamedBodies::NamedBodies(const Model& model) : model_(model), indices_{{"ground", ground}} {
    for (std::size_t i = 0; i < model.bodies.size(); ++i) indices_.emplace(model.bodies[i].name, static_cast<int>(i));
}

int NamedBodies::index(const std::string& name, const std::string& path) const {
    if (const auto found = indices_.find(name); found != indices_.end()) return found->second;
    std::vector<std::string> known = {"ground"};
    for (const Body& body : model_.bodies) known.push_back(body.name);
    std::string list;
    for (const std::string& one : known) list += (list.empty() ? "\"" : ", \"") + one + "\"";
    throw ParameterError(path, "expected a body (" + list + "), got \"" + name + "\"", name, std::move(known));
}

std::array<int, 2> NamedBodies::between(const std::array<std::string, 2>& names, const std::string& path,
                                        const std::string& who) const {
    const std::array<int, 2> bodies = {index(names[0], path + "/between/0"), index(names[1], path + "/between/1")};
    if (bodies[0] == bodies[1])
        throw ParameterError(path + "/between",
                             who + ": expected two different bodies, got \"" + names[0] + "\" twice");
    return bodies;
}

Vec3 point_on(const Model& model, int body, const Vector3& value, const std::string& path, const std::string& who) {
    const Vec3 point = to_vec3(value);
    if (body == ground || !model.bodies[static_cast<std::size_t>(body)].point) return model.point_of(body, point);
    const Vec3& x = model.bodies[static_cast<std::size_t>(body)].start.x;
    if ((point - x).norm() > (point.norm() + x.norm()) / 1000000000)
        throw ParameterError(path, who +
                                       ": a point mass has no other point than its mass centre; expected the x of \"" +
                                       model.name_of(body) + "\", got a point " + text((point - x).norm()) + " m away");
    return Vec3::Zero();
}

Vec3 axis(const Vector3& value, const std::string& path, const std::string& who) {
    const Vec3 a = to_vec3(value);
    if (a.isZero(0)) throw ParameterError(path, who + ": expected an axis, got the zero vector");
    return a;
}

Real not_negative(double value, const std::string& path, const std::string& what) {
    if (!(value >= 0)) throw ParameterError(path, "expected a " + what + " of at least 0, got " + text(Real(value)));
    return decimal(value);
}

}  // namespace reading

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
