// SPDX-License-Identifier: BSD-3-Clause
#include "tests/problems/states.hpp"

#include <Eigen/QR>
#include <random>

#include "lie/so3.hpp"

namespace states {

namespace {

class Random {
  public:
    Vec3 vector(const Real& size) { return size * Vec3(number(), number(), number()); }

  private:
    Real number() { return Real(static_cast<long>(engine_() % 2097152)) / 1048576 - 1; }
    std::mt19937 engine_{5};
};

/// Newton's iteration on Phi and one linear solve on C v + b, least changes; SO3xR3 coordinates.
void onto_joints(System& s, checks::At& at) {
    const int n = s.velocities(), m = s.constraints(), positions = s.position_constraints();
    MatX C(m, n);
    VecX residual(m);
    for (int i = 0; i < 12; ++i) {
        s.position_residual(at.t, at.y.data(), residual.data());
        s.jacobian(at.t, at.y.data(), C.data());
        const MatX rows = C.topRows(positions);
        const VecX u = rows.completeOrthogonalDecomposition().solve(-residual.head(positions));
        s.group().append_exp(at.y.data(), u.data(), at.y.data());
    }
    Real* v = s.v(at.y.data());
    s.jacobian(at.t, at.y.data(), C.data());
    s.velocity_residual(at.t, at.y.data(), v, residual.data());
    Eigen::Map<VecX>{v, n} -= C.completeOrthogonalDecomposition().solve(residual);
}

bool on_joints(const System& s, const checks::At& at) {
    VecX residual = VecX::Zero(s.constraints());
    s.position_residual(at.t, at.y.data(), residual.data());
    return residual.norm() <= 1000 * epsilon;
}

/// Where the angles of torsion springs are defined.
bool has_angles(System& s, const checks::At& at) { return s.begin_step(at.t, 0, at.y.data()) == Status::ok; }

bool near(const std::vector<BodyState>& a, const std::vector<BodyState>& b) {
    for (std::size_t i = 0; i < a.size(); ++i)
        if (!((a[i].x - b[i].x).norm() < 4)) return false;
    return true;
}

}  // namespace

std::vector<std::string> applicable(const Model& model) {
    std::vector<std::string> names;
    for (const Formulation& entry : formulations())
        if (entry.why_not(model).empty()) names.push_back(entry.name);
    return names;
}

checks::At in_coordinates(const System& system, const Pose& pose) {
    checks::At at{pose.t, std::vector<Real>(static_cast<std::size_t>(system.state_group().size()))};
    system.write(pose.bodies.data(), at.y.data());
    return at;
}

std::vector<Pose> poses(const Model& model, int count) {
    std::vector<Pose> all = {{0, {}}};
    for (const Body& body : model.bodies) all[0].bodies.push_back(body.start);
    const bool fixed_mass_centre = model.joints.empty() && formulation("SO3").why_not(model).empty();
    const auto system = make_system(model, "SO3xR3");
    Real reach = 1;  // joints that hold rotations let poses be drawn near the start only
    Random random;
    for (int i = 1; i <= count; ++i) {
        Pose pose = all[0];
        pose.t = Real(3 * i) / 7;
        for (int tries = 0; tries < 20; ++tries, reach /= 2) {
            const Real size = reach;
            pose.bodies = all[0].bodies;
            for (BodyState& body : pose.bodies) {
                body.R *= SO3::exp(size * random.vector(2));
                body.omega = random.vector(3);
                if (fixed_mass_centre) continue;  // a body that SO3 holds at its place has to stay there
                body.x += size * random.vector(Real(1) / 4);
                body.v = random.vector(3);
            }
            checks::At at = in_coordinates(*system, pose);
            if (!model.joints.empty()) onto_joints(*system, at);
            system->read(at.y.data(), pose.bodies.data());
            if (near(all[0].bodies, pose.bodies) && on_joints(*system, at) && has_angles(*system, at)) break;
        }
        all.push_back(pose);
    }
    return all;
}

}  // namespace states
