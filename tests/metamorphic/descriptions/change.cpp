// SPDX-License-Identifier: BSD-3-Clause
#include "tests/metamorphic/descriptions/change.hpp"

#include <algorithm>

#include "mechanics/model/symmetries.hpp"
#include "tests/mechanics/models/scaled.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {
namespace metamorphic {

namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Of frames of joints: the second axis is mirrored once more, so that the frame stays right-handed and rows keep their
/// terms.
const Mat3 second_axis = Vec3(1, -1, 1).asDiagonal();
/// Of frames of torsion springs: the third, about which the angle then keeps its sign.
const Mat3 third_axis = Vec3(1, 1, -1).asDiagonal();

}  // namespace

Mat3 Change::axes_of_body(int i) const { return axes.empty() ? Mat3(space) : axes[at(i)]; }
int Change::place(int i) const { return i == ground || bodies.empty() ? i : bodies[at(i)]; }

Vec3 Change::point(int body, const Vec3& r) const {
    return body == ground ? Vec3(length * (space * r) + shift) : Vec3(length * (axes_of_body(body) * r));
}

Mat3 Change::frame(int body, const Mat3& A, const Mat3& signs) const {
    const Mat3 turned = (body == ground ? space : axes_of_body(body)) * A;
    return mirrors() ? Mat3(turned * signs) : turned;
}

Body Change::body(const Body& old, int i) const {
    Body changed = old;
    const Mat3 B = axes_of_body(i);
    changed.name = prefix + old.name;
    changed.mass *= mass;
    if (!old.point) {
        const Mat3 J = mass * length * length * (B * old.J * B.transpose());
        changed.J = (J + J.transpose()) / 2;
    }
    const BodyState& s = old.start;
    changed.start = {length * (space * s.x) + shift, space * s.R * B.transpose(), length / time * (space * s.v),
                     hand() / time * (B * s.omega)};
    return changed;
}

Joint Change::joint(const Joint& old, bool reverse) const {
    Joint changed = old;
    changed.r_first = point(old.first, old.r_first), changed.r_second = point(old.second, old.r_second);
    changed.axes_first = frame(old.first, old.axes_first, second_axis);
    changed.axes_second = frame(old.second, old.axes_second, second_axis);
    changed.first = place(old.first), changed.second = place(old.second);
    changed.length *= length;
    changed.frequency /= time;
    const int back = reverse ? -1 : 1;
    changed.turn = models::scaled(old.turn, back * hand(), time);
    changed.shift = models::scaled(old.shift, back * length, time);
    changed.lead *= hand() * length;
    if (!reverse) return changed;
    std::swap(changed.first, changed.second), std::swap(changed.r_first, changed.r_second);
    std::swap(changed.axes_first, changed.axes_second), std::swap(changed.teeth[0], changed.teeth[1]);
    return changed;
}

Load Change::load(const Load& old) const {
    Load changed = old;
    const Mat3 B = axes_of_body(old.body), turn = old.axes == Load::Axes::space ? space : B;
    const Real force = mass * length / (time * time);
    changed.force = force * (turn * old.force);
    changed.torque = hand() * force * length * (turn * old.torque);
    changed.point = length * (B * old.point);
    changed.frequency /= time;
    changed.body = place(old.body);
    return changed;
}

Spring Change::spring(const Spring& old) const {
    Spring changed = old;
    changed.r_first = point(old.first, old.r_first), changed.r_second = point(old.second, old.r_second);
    changed.first = place(old.first), changed.second = place(old.second);
    changed.stiffness *= mass / (time * time), changed.damping *= mass / time, changed.length *= length;
    return changed;
}

TorsionSpring Change::torsion_spring(const TorsionSpring& old) const {
    TorsionSpring changed = old;
    changed.axes_first = frame(old.first, old.axes_first, third_axis);
    changed.axes_second = frame(old.second, old.axes_second, third_axis);
    changed.first = place(old.first), changed.second = place(old.second);
    changed.stiffness *= mass * length * length / (time * time), changed.damping *= mass * length * length / time;
    return changed;
}

PolynomialSpring Change::polynomial_spring(const PolynomialSpring& old) const {
    PolynomialSpring changed = old;
    changed.r_first = point(old.first, old.r_first), changed.r_second = point(old.second, old.r_second);
    changed.first = place(old.first), changed.second = place(old.second);
    Real unit = mass / (time * time);
    for (Real& coefficient : changed.coefficients) coefficient *= unit, unit /= length;
    changed.damping *= mass / time, changed.length *= length;
    return changed;
}

Damper Change::damper(const Damper& old) const {
    Damper changed = old;
    changed.r_second = point(old.second, old.r_second);
    changed.first = place(old.first), changed.second = place(old.second);
    changed.damping *= mass / time;
    return changed;
}

RotationalDamper Change::rotational_damper(const RotationalDamper& old) const {
    return {place(old.first), place(old.second), old.damping * mass * length * length / time};
}

Attraction Change::attraction(const Attraction& old) const {
    Attraction changed = old;
    changed.r_first = point(old.first, old.r_first), changed.r_second = point(old.second, old.r_second);
    changed.first = place(old.first), changed.second = place(old.second);
    changed.strength *= mass * length * length * length / (time * time);
    return changed;
}

/// A mirror that is not a coordinate plane of the bushing changes what its angles are: the second axis is mirrored once
/// more, so that p_2, q_1 and q_3 change their signs.
Bushing Change::bushing(const Bushing& old) const {
    Bushing changed = old;
    changed.r_first = point(old.first, old.r_first), changed.r_second = point(old.second, old.r_second);
    changed.axes_first = frame(old.first, old.axes_first, second_axis);
    changed.axes_second = frame(old.second, old.axes_second, second_axis);
    changed.first = place(old.first), changed.second = place(old.second);
    const Real force = mass / (time * time), torque = force * length * length;
    changed.stiffness = {force * old.stiffness[0], torque * old.stiffness[1]};
    changed.damping = {force * time * old.damping[0], torque * time * old.damping[1]};
    return changed;
}

Model Change::operator()(const Model& model) const {
    Model changed;
    changed.bodies.resize(model.bodies.size()), changed.joints.resize(model.joints.size());
    for (std::size_t i = 0; i < model.bodies.size(); ++i) {
        const int old = static_cast<int>(i);
        changed.bodies[at(place(old))] = body(model.bodies[i], old);
    }
    for (std::size_t j = 0; j < model.joints.size(); ++j)
        changed.joints[joints.empty() ? j : at(joints[j])] = joint(model.joints[j], !reversed.empty() && reversed[j]);
    for (const Load& old : model.loads) changed.loads.push_back(load(old));
    for (const Spring& old : model.springs) changed.springs.push_back(spring(old));
    for (const TorsionSpring& old : model.torsion_springs) changed.torsion_springs.push_back(torsion_spring(old));
    for (const PolynomialSpring& old : model.polynomial_springs)
        changed.polynomial_springs.push_back(polynomial_spring(old));
    for (const Damper& old : model.dampers) changed.dampers.push_back(damper(old));
    for (const RotationalDamper& old : model.rotational_dampers)
        changed.rotational_dampers.push_back(rotational_damper(old));
    for (const Attraction& old : model.attractions) changed.attractions.push_back(attraction(old));
    for (const Bushing& old : model.bushings) changed.bushings.push_back(bushing(old));
    changed.gravity = {length / (time * time) * (space * model.gravity.g), model.gravity.amplitude,
                       model.gravity.frequency / time};
    return changed;
}

Action Change::back(const Action& action) const {
    const Real force = mass * length / (time * time);
    return {space.transpose() * action.force / force, hand() / (force * length) * (space.transpose() * action.torque)};
}

Outcome Change::back(const Outcome& changed, const Model& model) const {
    Outcome old;
    old.failure = changed.failure;
    for (std::size_t i = 0; i < changed.bodies.size(); ++i) {
        const BodyState& s = changed.bodies[at(place(static_cast<int>(i)))];
        const Mat3 B = axes_of_body(static_cast<int>(i));
        old.bodies.push_back({space.transpose() * (s.x - shift) / length, space.transpose() * s.R * B,
                              space.transpose() * s.v * (time / length), hand() * time * (B.transpose() * s.omega)});
    }
    for (std::size_t i = 0; i < changed.totals.size(); ++i)
        old.totals.push_back(back(changed.totals[at(place(static_cast<int>(i)))]));
    for (std::size_t j = 0; j < changed.joints.size(); ++j) {
        const auto& on = changed.joints[joints.empty() ? j : at(joints[j])];
        const bool reverse = !reversed.empty() && reversed[j];
        old.joints.push_back({back(on[reverse ? 1 : 0]), back(on[reverse ? 0 : 1])});
    }
    old.integrals = integrals_back(changed, model);
    const Real force = mass * length / (time * time);
    old.sizes = {changed.sizes.x / length, changed.sizes.v * time / length, changed.sizes.omega * time,
                 changed.sizes.force / force, changed.sizes.torque / (force * length)};
    return old;
}

/// V = -m g.x is zero at the origin, and momenta are about the pivot that the changed model has. Components along x, y,
/// z are integrals of the original where they are such of the changed model, or where all three are.
std::map<std::string, Real> Change::integrals_back(const Outcome& changed, const Model& model) const {
    const Model other = (*this)(model);
    Vec3 p = Vec3::Zero();
    Real total = 0;
    for (std::size_t i = 0; i < other.bodies.size(); ++i)
        p += other.bodies[i].mass * changed.bodies[i].v, total += other.bodies[i].mass;
    const Real momentum = mass * length / time;
    const Vec3 arm = length * (space * pivot(model)) + shift - pivot(other);
    std::map<std::string, Real> old;
    for (const auto& [changed_name, value] : changed.integrals) {
        std::string name = changed_name;
        if (const auto place = name.find("_" + prefix); !prefix.empty() && place != std::string::npos)
            name.erase(place + 1, prefix.size());
        if (name == "energy")
            old[name] = (value + total * other.gravity.g.dot(shift)) * (time * time / (mass * length * length));
        else if (name == "angular_momentum_vertical")
            old[name] = hand() / (momentum * length) * (value - other.gravity.g.normalized().dot(p.cross(arm)));
        else if (name.starts_with("body_momentum"))
            old[name] = value / (momentum * length);
        else if (name.starts_with("kovalevskaya"))
            old[name] = value * (time * time) * (time * time);
    }
    add_components("momentum_", changed.integrals, Vec3::Zero(), 1 / momentum, old);
    add_components("angular_momentum_", changed.integrals, arm.cross(p), hand() / (momentum * length), old);
    return old;
}

/// (value - offset) factor of the components of a vector, carried back.
void Change::add_components(const std::string& name, const std::map<std::string, Real>& from, const Vec3& offset,
                            const Real& factor, std::map<std::string, Real>& to) const {
    Vec3 vector = Vec3::Zero();
    int known = 0;
    const auto key = [&](Eigen::Index k) { return name + "xyz"[k]; };
    for (Eigen::Index k = 0; k < 3; ++k)
        if (const auto found = from.find(key(k)); found != from.end()) vector[k] = found->second - offset[k], ++known;
    if (!space.isDiagonal() && known < 3) return;
    const Vec3 back = factor * (space.transpose() * vector);
    for (Eigen::Index k = 0; k < 3; ++k)
        if (from.contains(key(k))) to[key(k)] = back[k];
}

}  // namespace metamorphic
}  // namespace KREISEL_PRECISION
}  // namespace kreisel
