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
    const int n = s.velocities(), m = s.constraints();
    MatX C(m, n);
    VecX residual(m);
    for (int i = 0; i < 12; ++i) {
        s.position_residual(at.t, at.y.data(), residual.data());
        s.jacobian(at.t, at.y.data(), C.data());
        const VecX u = C.completeOrthogonalDecomposition().solve(-residual);
        s.group().append_exp(at.y.data(), u.data(), at.y.data());
    }
    Real* v = at.y.data() + s.group().size();
    s.jacobian(at.t, at.y.data(), C.data());
    s.velocity_residual(at.t, at.y.data(), v, residual.data());
    Eigen::Map<VecX>{v, n} -= C.completeOrthogonalDecomposition().solve(residual);
}

}  // namespace

Model standard(const Problem& problem) {
    ParameterValues values;
    for (const ParameterDescription& parameter : problem.description.parameters)
        values[parameter.name] = parameter.standard;
    return problem.build(Parameters(values));
}

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
    Random random;
    for (int i = 1; i <= count; ++i) {
        Pose pose = all[0];
        pose.t = Real(3 * i) / 7;
        for (BodyState& body : pose.bodies) {
            body.R *= SO3::exp(random.vector(2));
            body.omega = random.vector(3);
            if (fixed_mass_centre) continue;  // a body that SO3 holds at its place has to stay there
            body.x += random.vector(Real(1) / 4);
            body.v = random.vector(3);
        }
        checks::At at = in_coordinates(*system, pose);
        if (!model.joints.empty()) onto_joints(*system, at);
        system->read(at.y.data(), pose.bodies.data());
        all.push_back(pose);
    }
    return all;
}

}  // namespace states
