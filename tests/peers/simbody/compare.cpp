// SPDX-License-Identifier: BSD-3-Clause
#include "tests/peers/simbody/compare.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

#include "mechanics/joints/joint_rows.hpp"

namespace outside {

namespace {

/// Largest difference of two lists of vectors, relative to the largest vector, which may vanish, or to 1.
class Largest {
  public:
    void add(const Vec3& a, const Vec3& b) {
        const Real difference = (a - b).norm();
        if (difference_ < difference || std::isnan(difference)) difference_ = difference;  // NaN persists
        size_ = std::max({size_, a.norm(), b.norm()});
    }
    Real relative() const {
        REQUIRE(std::isfinite(difference_));
        return difference_ / size_;
    }

  private:
    Real difference_ = 0, size_ = 1;
};

std::vector<Real> state(const System& system, const std::vector<BodyState>& bodies) {
    std::vector<Real> y(static_cast<std::size_t>(system.state_group().size()));
    system.write(bodies.data(), y.data());
    return y;
}

/// x'' of a body from the linear part of v'; only SE(3) has its velocity in rotating axes, V = R^T x'.
Vec3 space_acceleration(const std::string& formulation, const Vec3& linear, const BodyState& body) {
    if (formulation != "SE3") return linear;
    return body.R * (linear + body.omega.cross(body.R.transpose() * body.v));
}

/// The wrench of a joint on a body: the part of -C^T lambda from its rows; C in the coordinates of SO3xR3.
Reaction reaction_of(const Model& model, const MatX& C, const VecX& lambda, int joint, int body) {
    int first = 0;
    for (int j = 0; j < joint; ++j) first += rows_of(model.joints[static_cast<std::size_t>(j)].type);
    const int rows = rows_of(model.joints[static_cast<std::size_t>(joint)].type);
    const Vec6 wrench = -C.block(first, 6 * body, rows, 6).transpose() * lambda.segment(first, rows);
    return {joint, body, wrench.head<3>(), wrench.tail<3>()};
}

Real reaction_difference(const Model& model, const Simbody& simbody, const std::vector<BodyState>& bodies) {
    const auto system = make_system(model, "SO3xR3");
    const auto y = state(*system, bodies);
    MatX C(system->constraints(), system->velocities());
    VecX lambda(system->constraints()), dv(system->velocities());
    system->jacobian(0, y.data(), C.data());
    REQUIRE(system->accelerations(0, y.data(), system->v(y.data()), dv.data(), lambda.data()) == Status::ok);
    Largest forces, torques;
    for (const Reaction& theirs : simbody.reactions()) {
        const Reaction ours = reaction_of(model, C, lambda, theirs.joint, theirs.body);
        forces.add(ours.force, theirs.force);
        torques.add(ours.torque, theirs.torque);
    }
    return std::max(forces.relative(), torques.relative());
}

bool is_redundant(const Model& model) {
    const ConstraintRank rank = make_system(model, "SO3xR3")->constraint_rank();
    return rank.rank < rank.rows;
}

}  // namespace

std::vector<Acceleration> accelerations(System& system, const std::string& formulation,
                                        const std::vector<BodyState>& bodies) {
    const auto y = state(system, bodies);
    VecX dv(system.velocities());
    REQUIRE(system.evaluate(0, y.data(), system.v(y.data()), dv.data()) == Status::ok);
    std::vector<Acceleration> result;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const auto part = dv.segment(6 * static_cast<Eigen::Index>(i), 6);
        result.push_back({space_acceleration(formulation, part.head<3>(), bodies[i]), part.tail<3>()});
    }
    return result;
}

Difference difference(const Model& model, const std::string& formulation, const Model& other,
                      const std::vector<BodyState>& bodies) {
    Simbody simbody(translate(other));
    simbody.set(translate(bodies));
    const auto held = simbody.poses();
    const auto theirs = simbody.accelerations();
    const auto system = make_system(model, formulation);
    const auto ours = accelerations(*system, formulation, bodies);
    Largest x, R, v, omega, linear, angular;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        x.add(held[i].x, bodies[i].x), v.add(held[i].v, bodies[i].v), omega.add(held[i].omega, bodies[i].omega);
        for (int k = 0; k < 3; ++k) R.add(held[i].R.col(k), bodies[i].R.col(k));
        linear.add(ours[i].linear, theirs[i].linear), angular.add(ours[i].angular, theirs[i].angular);
    }
    return {std::max({x.relative(), R.relative(), v.relative(), omega.relative()}),
            std::max(linear.relative(), angular.relative()),
            is_redundant(model) ? 0 : reaction_difference(model, simbody, bodies)};
}

}  // namespace outside
