// SPDX-License-Identifier: BSD-3-Clause
//
// Bodies that each turn about a fixed point: q = R, v = omega, no constraints. With the lever c from the point to
// the mass centre (body axes) and J_O = J + m (|c|^2 I - c c^T),
//   J_O omega' = c x (m R^T g + force) + torque - omega x J_O omega,   x = P + R c,   x' = R (omega x c),
// force and torque being those of loads and springs in body axes. The point exerts the force m (x'' - g) - R force.
// The `Coordinates` of a formulation define how R is stored (mechanics/formulations/body_layout.hpp):
//   name        of the formulation
//   Factor      the group of one body, a Kernel (lie/power.hpp) whose element is the rotation
//   Rotations   MatrixStorage, QuaternionStorage
#pragma once

#include <algorithm>
#include <memory>
#include <utility>

#include "lie/power.hpp"
#include "mechanics/forces/forces.hpp"
#include "mechanics/formulation.hpp"
#include "mechanics/formulations/body_layout.hpp"
#include "mechanics/model/pivots.hpp"
#include "mechanics/model/symmetries.hpp"
#include "mechanics/space_axes.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// For models for which `why_not_pivoted` is empty.
template <class Coordinates>
class PivotedBodies final : public System, public SpaceAxes {
  public:
    explicit PivotedBodies(Model model)
        : System(configurations(
              std::make_shared<Power<typename Coordinates::Factor>>(static_cast<int>(model.bodies.size())), model)),
          model_(std::move(model)),
          turns_(model_),
          bodies_(pivoted_bodies(model_)),
          forces_(has_forces(model_)) {}

    Status accelerations(const Real& t, const Real* q, const Real* v, Real* dv, Real* lambda) override;
    Status solve_kkt(const Real& t, const Real* q, const Real* f, const Real* c, Real* a, Real* lambda) override;
    Status reactions(const Real& t, const Real* q, const Real* v, const Real* lambda, JointReaction* out) override;
    int mass_block() const override { return 3; }
    void mass(const Real*, Real* blocks) const override {
        for (const Pivoted& body : bodies_) store(body.J_O, blocks), blocks += 9;
    }
    void solve_mass(const Real*, const Real* f, Real* a) const override {
        for (const Pivoted& body : bodies_) store(Vec3(body.J_O_inverse * vec3(f)), a), f += 3, a += 3;
    }
    /// Without v, at rest.
    void applied_force(const Real& t, const Real* q, const Real* v, Real* f) const override;
    void gyroscopic_force(const Real* q, const Real* v, Real* f) const override;
    void conservative_force(const Real& t, const Real* q, Real* f) const override { applied_force(t, q, nullptr, f); }
    void dissipative_force(const Real& t, const Real* q, const Real* v, Real* f) const override;
    bool is_dissipative() const override { return has_dampers(model_); }
    bool has_potential() const override { return is_conservative(model_); }
    Real potential(const Real& t, const Real* q) const override;
    int bodies() const override { return static_cast<int>(bodies_.size()); }
    void read(const Real* y, BodyState* states) const override;
    void write(const BodyState* states, Real* y) const override;

    std::string reason(Status status) const override { return status == Status::turn_lost ? turns_.reason() : ""; }
    Status begin_step(const Real& t, const Real& h, const Real* y) override {
        return turns_.begin_step(t, h, labels(y), [&](int body) { return motion(y, this->v(y), body); });
    }
    Status end_step(Status result, const Real& t, Real* y) override {
        return turns_.end_step(result, t, labels(y), [&](int body) { return motion(y, this->v(y), body); });
    }
    void read_angles(const Real* q, SpringAngle* angles) const override {
        for (std::size_t i = 0; i < model_.torsion_springs.size(); ++i)
            angles[i] = turns_.read(i, labels(q), [&](int body) { return motion(q, nullptr, body); });
    }

    void to_space_axes(const Real* q, const Real* v, Real* turned) const override {
        for (std::size_t i = 0; i < bodies_.size(); ++i, q += size, v += 3, turned += 3)
            store(Vec3(Coordinates::Rotations::rotation(q) * vec3(v)), turned);
    }
    void from_space_axes(const Real* q, const Real* turned, Real* v) const override {
        for (std::size_t i = 0; i < bodies_.size(); ++i, q += size, turned += 3, v += 3)
            store(Vec3(Coordinates::Rotations::rotation(q).transpose() * vec3(turned)), v);
    }

  private:
    static constexpr int size = Coordinates::Factor::size;

    static auto rotation(const Real* q, std::size_t body) {
        return Coordinates::Rotations::rotation(q + body * static_cast<std::size_t>(size));
    }
    static Vec3 gravity_torque(const Pivoted& body, const auto& R, const Vec3& g) {
        return body.lever.cross(body.mass * (R.transpose() * g));
    }
    Motion motion(const Real* q, const Real* v, int body) const;
    /// Calls push(body, wrench) for what loads and springs exert, in body axes.
    template <class Push>
    void each_wrench(const Real& t, const Real* q, const Real* v, Push push) const {
        for_each_wrench(
            model_, t, [&](int body) { return motion(q, v, body); },
            [&](std::size_t i, const Turn& turn) { return turns_.angle(i, turn, t, labels(q)); }, push);
    }
    /// Of a force about the fixed point of the body, in body axes.
    Vec3 moment_of(int body, const Wrench& wrench) const {
        return bodies_[static_cast<std::size_t>(body)].lever.cross(wrench.force) + wrench.torque;
    }
    /// Calls f(body, moment).
    template <class F>
    void each_moment(const Real& t, const Real* q, const Real* v, F f) const {
        if (!forces_) return;
        each_wrench(t, q, v, [&](int body, const Wrench& wrench) { f(body, moment_of(body, wrench)); });
    }

    Model model_;
    Turns turns_;
    std::vector<Pivoted> bodies_;
    bool forces_;  // whether anything but gravity acts
};

template <class Coordinates>
Motion PivotedBodies<Coordinates>::motion(const Real* q, const Real* v, int body) const {
    if (body == ground) return {};
    const Pivoted& mine = bodies_[static_cast<std::size_t>(body)];
    const Mat3 R = rotation(q, static_cast<std::size_t>(body));
    Motion motion{mine.pivot + R * mine.lever, R};
    if (v) motion.omega = vec3(v + 3 * body), motion.V = motion.omega.cross(mine.lever);
    return motion;
}

template <class Coordinates>
KREISEL_HOT Status PivotedBodies<Coordinates>::accelerations(const Real& t, const Real* q, const Real* v, Real* dv,
                                                             Real*) {
    const Vec3 g = model_.gravity.at(t);
    Real sum = 0;
    const Real *const configuration = q, *const velocities = v;
    Real* const rates = dv;
    for (const Pivoted& body : bodies_) {
        const Vec3 w = vec3(v), Jw = body.J_O * w;
        const Vec3 dw = body.J_O_inverse * (gravity_torque(body, Coordinates::Rotations::rotation(q), g) + Jw.cross(w));
        sum += dw.sum();
        store(dw, dv);
        q += size, v += 3, dv += 3;
    }
    each_moment(t, configuration, velocities, [&](int body, const Vec3& moment) {
        Real* mine = rates + 3 * body;
        store(Vec3(vec3(mine) + bodies_[static_cast<std::size_t>(body)].J_O_inverse * moment), mine);
        sum += vec3(mine).sum();
    });
    return isfinite(sum) ? turns_.status() : Status::non_finite;
}

template <class Coordinates>
Status PivotedBodies<Coordinates>::solve_kkt(const Real&, const Real*, const Real* f, const Real*, Real* a, Real*) {
    Real sum = 0;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        const Vec3 dw = f ? Vec3(bodies_[i].J_O_inverse * vec3(f + 3 * i)) : Vec3(Vec3::Zero());
        sum += dw.sum();
        store(dw, a + 3 * i);
    }
    return isfinite(sum) ? Status::ok : Status::non_finite;
}

/// Spherical joints exert no torque about their point.
template <class Coordinates>
Status PivotedBodies<Coordinates>::reactions(const Real& t, const Real* q, const Real* v, const Real*,
                                             JointReaction* out) {
    std::vector<Real> dv(static_cast<std::size_t>(velocities()));
    const Status status = accelerations(t, q, v, dv.data(), nullptr);
    const Vec3 g = model_.gravity.at(t);
    std::vector<Vec3> on_body;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        const Vec3 w = vec3(v + 3 * i), c = bodies_[i].lever;
        const Vec3 A = vec3(&dv[3 * i]).cross(c) + w.cross(w.cross(c));
        on_body.push_back(bodies_[i].mass * (rotation(q, i) * A - g));
    }
    each_wrench(t, q, v, [&](int body, const Wrench& wrench) {
        const auto i = static_cast<std::size_t>(body);
        on_body[i] -= rotation(q, i) * wrench.force;
    });
    for (std::size_t j = 0; j < model_.joints.size(); ++j) {
        const auto& [first, second] = std::pair(model_.joints[j].first, model_.joints[j].second);
        const Vec3& force = on_body[static_cast<std::size_t>(second == ground ? first : second)];
        out[j].force = second == ground ? Vec3(-force) : force;
        out[j].torque.setZero();
    }
    return status;
}

template <class Coordinates>
void PivotedBodies<Coordinates>::applied_force(const Real& t, const Real* q, const Real* v, Real* f) const {
    const Vec3 g = model_.gravity.at(t);
    for (std::size_t i = 0; i < bodies_.size(); ++i) store(gravity_torque(bodies_[i], rotation(q, i), g), f + 3 * i);
    each_moment(t, q, v, [&](int body, const Vec3& moment) {
        Real* mine = f + 3 * body;
        store(Vec3(vec3(mine) + moment), mine);
    });
}

template <class Coordinates>
void PivotedBodies<Coordinates>::dissipative_force(const Real&, const Real* q, const Real* v, Real* f) const {
    std::fill_n(f, velocities(), Real(0));
    for_each_damping(
        model_, [&](int body) { return motion(q, v, body); },
        [&](int body, const Wrench& wrench) {
            Real* mine = f + 3 * body;
            store(Vec3(vec3(mine) + moment_of(body, wrench)), mine);
        });
}

template <class Coordinates>
void PivotedBodies<Coordinates>::gyroscopic_force(const Real*, const Real* v, Real* f) const {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        const Vec3 w = vec3(v + 3 * i);
        store(Vec3(-w.cross(bodies_[i].J_O * w)), f + 3 * i);
    }
}

template <class Coordinates>
Real PivotedBodies<Coordinates>::potential(const Real& t, const Real* q) const {
    const Vec3 g = model_.gravity.at(t);
    const auto at = [&](int body) { return motion(q, nullptr, body); };
    Real sum = stored_energy(model_, at, [&](std::size_t i) { return turns_.read(i, labels(q), at).theta; });
    for (std::size_t i = 0; i < bodies_.size(); ++i)
        sum -= bodies_[i].mass * g.dot(bodies_[i].pivot + rotation(q, i) * bodies_[i].lever);
    return sum;
}

template <class Coordinates>
void PivotedBodies<Coordinates>::read(const Real* y, BodyState* states) const {
    const Real* v = this->v(y);
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        const Mat3 R = rotation(y, i);
        const Vec3 w = vec3(v + 3 * i);
        states[i] = {bodies_[i].pivot + R * bodies_[i].lever, R, R * w.cross(bodies_[i].lever), w};
    }
}

template <class Coordinates>
void PivotedBodies<Coordinates>::write(const BodyState* states, Real* y) const {
    Real* v = this->v(y);
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        Coordinates::Rotations::save(states[i].R, y + i * static_cast<std::size_t>(size));
        store(states[i].omega, v + 3 * i);
    }
}

/// The formulation of these coordinates, under its summary.
template <class Coordinates>
Formulation pivoted_formulation(Formulation formulation) {
    formulation.name = Coordinates::name;
    formulation.why_not = [](const Model& model) { return why_not_pivoted(model, Coordinates::name); };
    formulation.make = [](const Model& model) -> std::unique_ptr<System> {
        return std::make_unique<PivotedBodies<Coordinates>>(model);
    };
    return formulation;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
