// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/formulations/pivoted_bodies.hpp"

#include <Eigen/LU>
#include <algorithm>

namespace kreisel {
inline namespace KREISEL_PRECISION {

std::vector<const Joint*> joints_of(const Model& model, int body) {
    std::vector<const Joint*> joints;
    for (const Joint& joint : model.joints)
        if (joint.first == body || joint.second == body) joints.push_back(&joint);
    return joints;
}

PivotedBodies::PivotedBodies(Model model)
    : System(configurations(std::make_shared<Power<SO3>>(static_cast<int>(model.bodies.size())), model)),
      model_(std::move(model)),
      turns_(model_),
      forces_(has_forces(model_)) {
    for (std::size_t i = 0; i < model_.bodies.size(); ++i) {
        const Body& body = model_.bodies[i];
        const auto joints = joints_of(model_, static_cast<int>(i));
        Vec3 lever = Vec3::Zero(), pivot = body.start.x;
        if (!joints.empty()) {
            const Joint& joint = *joints[0];
            lever = -(joint.first == ground ? joint.r_second : joint.r_first);
            pivot = joint.first == ground ? joint.r_first : joint.r_second;
        }
        const Mat3 J_O = inertia_about(body, lever);
        bodies_.push_back({body.mass, J_O, J_O.inverse(), pivot, lever});
    }
}

Motion PivotedBodies::motion(const Real* q, const Real* v, int body) const {
    if (body == ground) return {};
    const Pivoted& mine = bodies_[static_cast<std::size_t>(body)];
    const Mat3 R = mat3(q + body * SO3::size);
    Motion motion{mine.pivot + R * mine.lever, R};
    if (v) motion.omega = vec3(v + 3 * body), motion.V = motion.omega.cross(mine.lever);
    return motion;
}

template <class F>
void PivotedBodies::each_moment(const Real& t, const Real* q, const Real* v, F f) const {
    if (!forces_) return;
    for_each_wrench(
        model_, t, [&](int body) { return motion(q, v, body); },
        [&](std::size_t i, const Turn& turn) { return turns_.angle(i, turn, t, labels(q)); },
        [&](int body, const Wrench& wrench) {
            const Vec3& lever = bodies_[static_cast<std::size_t>(body)].lever;
            f(body, Vec3(lever.cross(wrench.force) + wrench.torque));
        });
}

KREISEL_HOT Status PivotedBodies::accelerations(const Real& t, const Real* q, const Real* v, Real* dv, Real*) {
    const Vec3 g = model_.gravity.at(t);
    Real sum = 0;
    const Real *const configuration = q, *const velocities = v;
    Real* const rates = dv;
    for (const Pivoted& body : bodies_) {
        const Vec3 w = vec3(v), Jw = body.J_O * w;
        const Vec3 dw = body.J_O_inverse * (gravity_torque(body, mat3(q), g) + Jw.cross(w));
        sum += dw.sum();
        store(dw, dv);
        q += SO3::size, v += 3, dv += 3;
    }
    each_moment(t, configuration, velocities, [&](int body, const Vec3& moment) {
        Real* mine = rates + 3 * body;
        store(Vec3(vec3(mine) + bodies_[static_cast<std::size_t>(body)].J_O_inverse * moment), mine);
        sum += vec3(mine).sum();
    });
    return isfinite(sum) ? turns_.status() : Status::non_finite;
}

Status PivotedBodies::solve_kkt(const Real&, const Real*, const Real* f, const Real*, Real* a, Real*) {
    Real sum = 0;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        const Vec3 dw = f ? Vec3(bodies_[i].J_O_inverse * vec3(f + 3 * i)) : Vec3(Vec3::Zero());
        sum += dw.sum();
        store(dw, a + 3 * i);
    }
    return isfinite(sum) ? Status::ok : Status::non_finite;
}

/// Spherical joints exert no torque about their point.
Status PivotedBodies::reactions(const Real& t, const Real* q, const Real* v, const Real*, JointReaction* out) {
    std::vector<Real> dv(static_cast<std::size_t>(velocities()));
    const Status status = accelerations(t, q, v, dv.data(), nullptr);
    const Vec3 g = model_.gravity.at(t);
    std::vector<Vec3> on_body;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        const Vec3 w = vec3(v + 3 * i), c = bodies_[i].lever;
        const Vec3 A = vec3(&dv[3 * i]).cross(c) + w.cross(w.cross(c));
        on_body.push_back(bodies_[i].mass * (mat3(q + i * SO3::size) * A - g));
    }
    for_each_wrench(
        model_, t, [&](int body) { return motion(q, v, body); },
        [&](std::size_t i, const Turn& turn) { return turns_.angle(i, turn, t, labels(q)); },
        [&](int body, const Wrench& wrench) {
            on_body[static_cast<std::size_t>(body)] -= mat3(q + body * SO3::size) * wrench.force;
        });
    for (std::size_t j = 0; j < model_.joints.size(); ++j) {
        const auto& [first, second] = std::pair(model_.joints[j].first, model_.joints[j].second);
        const Vec3& force = on_body[static_cast<std::size_t>(second == ground ? first : second)];
        out[j].force = second == ground ? Vec3(-force) : force;
        out[j].torque.setZero();
    }
    return status;
}

void PivotedBodies::mass(const Real*, Real* blocks) const {
    for (const Pivoted& body : bodies_) store(body.J_O, blocks), blocks += 9;
}

void PivotedBodies::applied_force(const Real& t, const Real* q, const Real* v, Real* f) const {
    const Vec3 g = model_.gravity.at(t);
    for (std::size_t i = 0; i < bodies_.size(); ++i)
        store(gravity_torque(bodies_[i], mat3(q + i * SO3::size), g), f + 3 * i);
    each_moment(t, q, v, [&](int body, const Vec3& moment) {
        Real* mine = f + 3 * body;
        store(Vec3(vec3(mine) + moment), mine);
    });
}

void PivotedBodies::gyroscopic_force(const Real*, const Real* v, Real* f) const {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        const Vec3 w = vec3(v + 3 * i);
        store(Vec3(-w.cross(bodies_[i].J_O * w)), f + 3 * i);
    }
}

void PivotedBodies::to_space_axes(const Real* q, const Real* v, Real* turned) const {
    for (std::size_t i = 0; i < bodies_.size(); ++i, q += SO3::size, v += 3, turned += 3)
        store(Vec3(mat3(q) * vec3(v)), turned);
}

void PivotedBodies::from_space_axes(const Real* q, const Real* turned, Real* v) const {
    for (std::size_t i = 0; i < bodies_.size(); ++i, q += SO3::size, turned += 3, v += 3)
        store(Vec3(mat3(q).transpose() * vec3(turned)), v);
}

Real PivotedBodies::potential(const Real& t, const Real* q) const {
    const Vec3 g = model_.gravity.at(t);
    const auto at = [&, q](int body) { return motion(q, nullptr, body); };
    Real sum = stored_energy(model_, at, [&, q](std::size_t i) { return turns_.read(i, labels(q), at).theta; });
    for (const Pivoted& body : bodies_) {
        sum -= body.mass * g.dot(body.pivot + mat3(q) * body.lever);
        q += SO3::size;
    }
    return sum;
}

void PivotedBodies::read(const Real* y, BodyState* states) const {
    const Real* v = this->v(y);
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        const Mat3 R = mat3(y + i * SO3::size);
        const Vec3 w = vec3(v + 3 * i);
        states[i] = {bodies_[i].pivot + R * bodies_[i].lever, R, R * w.cross(bodies_[i].lever), w};
    }
}

void PivotedBodies::write(const BodyState* states, Real* y) const {
    Real* v = this->v(y);
    for (std::size_t i = 0; i < bodies_.size(); ++i)
        store(states[i].R, y + i * SO3::size), store(states[i].omega, v + 3 * i);
}

Status PivotedBodies::begin_step(const Real& t, const Real& h, const Real* y) {
    const Real* v = this->v(y);
    return turns_.begin_step(t, h, labels(y), [&](int body) { return motion(y, v, body); });
}

Status PivotedBodies::end_step(Status result, const Real& t, Real* y) {
    const Real* v = this->v(y);
    return turns_.end_step(result, t, labels(y), [&](int body) { return motion(y, v, body); });
}

void PivotedBodies::read_angles(const Real* q, SpringAngle* angles) const {
    for (std::size_t i = 0; i < model_.torsion_springs.size(); ++i)
        angles[i] = turns_.read(i, labels(q), [&](int body) { return motion(q, nullptr, body); });
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
