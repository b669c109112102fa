// SPDX-License-Identifier: BSD-3-Clause
//
// Bodies of six degrees of freedom each, in the coordinates of a formulation: states, inertia and forces. What joints
// add is in mechanics/formulations/constrained_bodies.hpp.
#pragma once

#include <Eigen/LU>
#include <algorithm>
#include <memory>
#include <utility>

#include "lie/power.hpp"
#include "mechanics/forces/forces.hpp"
#include "mechanics/formulations/body_layout.hpp"
#include "mechanics/model/symmetries.hpp"
#include "mechanics/space_axes.hpp"
#include "mechanics/system.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

template <class Coordinates>
class FreeBodies : public System, public SpaceAxes {
  public:
    explicit FreeBodies(Model model);

    int bodies() const override { return static_cast<int>(model_.bodies.size()); }
    void read(const Real* y, BodyState* states) const override;
    void write(const BodyState* states, Real* y) const override;
    void to_space_axes(const Real* q, const Real* v, Real* turned) const override;
    void from_space_axes(const Real* q, const Real* turned, Real* v) const override;

    int mass_block() const override { return 6; }
    void mass(const Real* q, Real* blocks) const override;
    void solve_mass(const Real* q, const Real* f, Real* a) const override;
    /// Without v, at rest.
    void applied_force(const Real& t, const Real* q, const Real* v, Real* f) const override;
    void gyroscopic_force(const Real* q, const Real* v, Real* f) const override;
    void conservative_force(const Real& t, const Real* q, Real* f) const override { applied_force(t, q, nullptr, f); }
    void dissipative_force(const Real& t, const Real* q, const Real* v, Real* f) const override;
    bool is_dissipative() const override { return has_dampers(model_); }
    bool has_potential() const override { return is_conservative(model_); }
    Real potential(const Real& t, const Real* q) const override;

    std::string reason(Status status) const override { return status == Status::turn_lost ? turns_.reason() : ""; }
    Status begin_step(const Real& t, const Real& h, const Real* y) override {
        return turns_.begin_step(t, h, labels(y), [&](int body) { return Layout::motion(y, this->v(y), body); });
    }
    Status end_step(Status result, const Real& t, Real* y) override {
        return turns_.end_step(result, t, labels(y), [&](int body) { return Layout::motion(y, this->v(y), body); });
    }
    void read_angles(const Real* q, SpringAngle* angles) const override {
        for (std::size_t i = 0; i < model_.torsion_springs.size(); ++i)
            angles[i] = turns_.read(i, labels(q), [&](int body) { return Layout::motion(q, nullptr, body); });
    }

  protected:
    using Layout = BodyLayout<Coordinates>;

    const Model& model() const { return model_; }
    const Mat3& J_inverse(std::size_t body) const { return J_inverse_[body]; }
    const Turns& turns() const { return turns_; }
    /// Calls push(body, wrench) for what loads and springs exert, in body axes.
    template <class Push>
    void each_wrench(const Real& t, const Real* q, const Real* v, Push push) const {
        for_each_wrench(
            model_, t, [&](int body) { return Layout::motion(q, v, body); },
            [&](std::size_t i, const Turn& turn) { return turns_.angle(i, turn, t, labels(q)); }, push);
    }
    /// Adds a force and a torque in body axes to those on a body.
    static void add_wrench(const Real* q, int body, const Vec3& force, const Vec3& torque, Real* f) {
        Real* mine = f + 6 * body;
        store(Vec3(vec3(mine) + Coordinates::from_body(Layout::rotation(q, body), force)), mine);
        store(Vec3(vec3(mine + 3) + torque), mine + 3);
    }

  private:
    Model model_;
    std::vector<Mat3> J_inverse_;
    Turns turns_;
};

template <class Coordinates>
FreeBodies<Coordinates>::FreeBodies(Model model)
    : System(configurations(
          std::make_shared<Power<typename Coordinates::Factor>>(static_cast<int>(model.bodies.size())), model)),
      model_(std::move(model)),
      turns_(model_) {
    for (const Body& body : model_.bodies) J_inverse_.push_back(body.J.inverse());
}

template <class Coordinates>
void FreeBodies<Coordinates>::read(const Real* y, BodyState* states) const {
    const Real* v = this->v(y);
    for (int i = 0; i < bodies(); ++i) {
        const auto R = Layout::rotation(y, i);
        states[i] = {Layout::position(y, i), R, Coordinates::to_space(R, Layout::linear(v, i)), Layout::angular(v, i)};
    }
}

template <class Coordinates>
void FreeBodies<Coordinates>::write(const BodyState* states, Real* y) const {
    Real* v = this->v(y);
    for (int i = 0; i < bodies(); ++i) {
        const BodyState& state = states[i];
        Real* pose = y + i * Layout::pose_size;
        store(state.x, pose), Coordinates::Rotations::save(state.R, pose + 3);
        store(Coordinates::from_space(Layout::rotation(y, i), state.v), v + 6 * i), store(state.omega, v + 6 * i + 3);
    }
}

template <class Coordinates>
KREISEL_HOT void FreeBodies<Coordinates>::to_space_axes(const Real* q, const Real* v, Real* turned) const {
    for (int i = 0; i < bodies(); ++i, v += 6, turned += 6) {
        const auto R = Layout::rotation(q, i);
        const Vec3 linear = Coordinates::to_space(R, vec3(v)), angular = R * vec3(v + 3);
        store(linear, turned), store(angular, turned + 3);
    }
}

template <class Coordinates>
KREISEL_HOT void FreeBodies<Coordinates>::from_space_axes(const Real* q, const Real* turned, Real* v) const {
    for (int i = 0; i < bodies(); ++i, turned += 6, v += 6) {
        const auto R = Layout::rotation(q, i);
        const Vec3 linear = Coordinates::from_space(R, vec3(turned)), angular = R.transpose() * vec3(turned + 3);
        store(linear, v), store(angular, v + 3);
    }
}

template <class Coordinates>
void FreeBodies<Coordinates>::mass(const Real*, Real* blocks) const {
    for (const Body& body : model_.bodies) {
        Eigen::Map<Eigen::Matrix<Real, 6, 6>> block(blocks);
        block.setZero();
        block.template topLeftCorner<3, 3>() = body.mass * Mat3::Identity();
        block.template bottomRightCorner<3, 3>() = body.J;
        blocks += 36;
    }
}

template <class Coordinates>
void FreeBodies<Coordinates>::solve_mass(const Real*, const Real* f, Real* a) const {
    for (std::size_t i = 0; i < model_.bodies.size(); ++i, f += 6, a += 6) {
        store(Vec3(inverse_mass(model_.bodies[i]) * vec3(f)), a);
        store(Vec3(J_inverse_[i] * vec3(f + 3)), a + 3);
    }
}

template <class Coordinates>
void FreeBodies<Coordinates>::applied_force(const Real& t, const Real* q, const Real* v, Real* f) const {
    const Vec3 g = model_.gravity.at(t);
    for (int i = 0; i < bodies(); ++i) {
        const Real& mass = model_.bodies[static_cast<std::size_t>(i)].mass;
        store(Vec3(mass * Coordinates::from_space(Layout::rotation(q, i), g)), f + 6 * i);
        store(Vec3(Vec3::Zero()), f + 6 * i + 3);
    }
    each_wrench(t, q, v, [&](int body, const Wrench& wrench) { add_wrench(q, body, wrench.force, wrench.torque, f); });
}

template <class Coordinates>
void FreeBodies<Coordinates>::dissipative_force(const Real&, const Real* q, const Real* v, Real* f) const {
    std::fill_n(f, this->velocities(), Real(0));
    for_each_damping(
        model_, [&](int body) { return Layout::motion(q, v, body); },
        [&](int body, const Wrench& wrench) { add_wrench(q, body, wrench.force, wrench.torque, f); });
}

template <class Coordinates>
void FreeBodies<Coordinates>::gyroscopic_force(const Real*, const Real* v, Real* f) const {
    for (const Body& body : model_.bodies) {
        const Vec3 w = vec3(v + 3);
        store(Coordinates::gyroscopic(body.mass, w, vec3(v)), f);
        store(Vec3(-w.cross(body.J * w)), f + 3);
        v += 6, f += 6;
    }
}

template <class Coordinates>
Real FreeBodies<Coordinates>::potential(const Real& t, const Real* q) const {
    const Vec3 g = model_.gravity.at(t);
    const auto at = [&](int body) { return Layout::motion(q, nullptr, body); };
    Real sum = stored_energy(model_, at, [&](std::size_t i) { return turns_.read(i, labels(q), at).theta; });
    for (int i = 0; i < bodies(); ++i)
        sum -= model_.bodies[static_cast<std::size_t>(i)].mass * g.dot(Layout::position(q, i));
    return sum;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
