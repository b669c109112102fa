// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/pivoted_bodies.hpp"

#include <Eigen/LU>
#include <algorithm>

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

std::vector<const SphericalJoint*> joints_of(const Model& model, int body) {
    std::vector<const SphericalJoint*> joints;
    for (const SphericalJoint& joint : model.joints)
        if (joint.first == body || joint.second == body) joints.push_back(&joint);
    return joints;
}

bool rests_unloaded(const Model& model, int index) {
    for (const Load& load : model.loads)
        if (load.body == index && !load.force.isZero(0)) return false;
    return model.bodies[static_cast<std::size_t>(index)].start.v.isZero(0) && model.gravity.g.isZero(0);
}

}  // namespace

std::string PivotedBodies::why_not(const Model& model) {
    for (std::size_t i = 0; i < model.bodies.size(); ++i) {
        const Body& body = model.bodies[i];
        const auto joints = joints_of(model, static_cast<int>(i));
        if (joints.empty() && !rests_unloaded(model, static_cast<int>(i)))
            return "body \"" + body.name + "\" has no fixed point: no spherical joint to the ground holds it";
        if (joints.size() > 1) return "body \"" + body.name + "\" has more than one joint, so SO3 cannot remove them";
        if (joints.size() == 1 && joints[0]->first != ground)
            return "body \"" + body.name + "\" is joined to a moving body, so no point of it is fixed";
    }
    return "";
}

PivotedBodies::PivotedBodies(Model model)
    : System(std::make_shared<Power<SO3>>(static_cast<int>(model.bodies.size()))), gravity_(model.gravity), loads_(model.loads) {
    for (std::size_t i = 0; i < model.bodies.size(); ++i) {
        const Body& body = model.bodies[i];
        const auto joints = joints_of(model, static_cast<int>(i));
        const Vec3 lever = joints.empty() ? Vec3(Vec3::Zero()) : Vec3(-joints[0]->r_second);
        const Vec3 pivot = joints.empty() ? body.start.x : joints[0]->r_first;
        const Mat3 J_O = inertia_about(body, lever);
        bodies_.push_back({body.mass, J_O, J_O.inverse(), pivot, lever});
    }
}

KREISEL_HOT Status PivotedBodies::accelerations(const Real& t, const Real* q, const Real* v, Real* dv, Real*) {
    const Vec3 g = gravity_.at(t);
    Real sum = 0;
    const Real* const configuration = q;
    Real* const rates = dv;
    for (const Pivoted& body : bodies_) {
        const Vec3 w = vec3(v), Jw = body.J_O * w;
        const Vec3 dw = body.J_O_inverse * (gravity_torque(body, mat3(q), g) + Jw.cross(w));
        sum += dw.sum();
        store(dw, dv);
        q += SO3::size, v += 3, dv += 3;
    }
    for (const Load& load : loads_) {
        Real* mine = rates + 3 * load.body;
        const Mat3& J_O_inverse = bodies_[static_cast<std::size_t>(load.body)].J_O_inverse;
        store(Vec3(vec3(mine) + J_O_inverse * moment(load, t, configuration)), mine);
        sum += vec3(mine).sum();
    }
    return isfinite(sum) ? Status::ok : Status::non_finite;
}

Status PivotedBodies::solve_kkt(const Real&, const Real*, const Real* f, const Real*, Real* a, Real*) {
    Real sum = 0;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        const Vec3 dw = bodies_[i].J_O_inverse * vec3(f + 3 * i);
        sum += dw.sum();
        store(dw, a + 3 * i);
    }
    return isfinite(sum) ? Status::ok : Status::non_finite;
}

void PivotedBodies::mass(const Real*, Real* blocks) const {
    for (const Pivoted& body : bodies_) store(body.J_O, blocks), blocks += 9;
}

void PivotedBodies::applied_force(const Real& t, const Real* q, const Real*, Real* f) const {
    const Vec3 g = gravity_.at(t);
    for (std::size_t i = 0; i < bodies_.size(); ++i)
        store(gravity_torque(bodies_[i], mat3(q + i * SO3::size), g), f + 3 * i);
    for (const Load& load : loads_) {
        Real* mine = f + 3 * load.body;
        store(Vec3(vec3(mine) + moment(load, t, q)), mine);
    }
}

void PivotedBodies::gyroscopic_force(const Real*, const Real* v, Real* f) const {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        const Vec3 w = vec3(v + 3 * i);
        store(Vec3(-w.cross(bodies_[i].J_O * w)), f + 3 * i);
    }
}

Real PivotedBodies::potential(const Real& t, const Real* q) const {
    const Vec3 g = gravity_.at(t);
    Real sum = 0;
    for (const Pivoted& body : bodies_) {
        sum -= body.mass * g.dot(body.pivot + mat3(q) * body.lever);
        q += SO3::size;
    }
    return sum;
}

void PivotedBodies::read(const Real* y, BodyState* states) const {
    const Real* v = y + group().size();
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        const Mat3 R = mat3(y + i * SO3::size);
        const Vec3 w = vec3(v + 3 * i);
        states[i] = {bodies_[i].pivot + R * bodies_[i].lever, R, R * w.cross(bodies_[i].lever), w};
    }
}

void PivotedBodies::write(const BodyState* states, Real* y) const {
    Real* v = y + group().size();
    for (std::size_t i = 0; i < bodies_.size(); ++i)
        store(states[i].R, y + i * SO3::size), store(states[i].omega, v + 3 * i);
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
