// SPDX-License-Identifier: BSD-3-Clause
//
// One body as two, rigidly joined: a quarter and three quarters of its mass, apart by half of its least radius of
// gyration. What was on the body is on the first part.
#include <Eigen/Eigenvalues>

#include "tests/metamorphic/descriptions/transformation.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {
namespace metamorphic {

namespace {

/// Two parts of a body: mass and mass centre (axes of the body, from its mass centre) of each, and the inertia of both.
struct Parts {
    int body;
    Real first_mass, second_mass;
    Vec3 first, second;
    Mat3 first_J, second_J;
};

Parts parts_of(const Model& model, int body) {
    const Body& whole = model.bodies[static_cast<std::size_t>(body)];
    const Eigen::SelfAdjointEigenSolver<Mat3> moments(whole.J, Eigen::EigenvaluesOnly);
    const Vec3 apart = sqrt(moments.eigenvalues()[0] / whole.mass) / 6 * Vec3(2, -1, 2);
    Parts parts{body, whole.mass / 4, whole.mass - whole.mass / 4, Real(3) / 4 * apart, -apart / 4, {}, {}};
    const Real reduced = parts.first_mass * parts.second_mass / whole.mass;
    const Mat3 rest = whole.J - reduced * (apart.squaredNorm() * Mat3::Identity() - apart * apart.transpose());
    parts.first_J = rest / 4, parts.second_J = rest - parts.first_J;
    return parts;
}

BodyState part_state(const BodyState& whole, const Vec3& centre) {
    return {whole.x + whole.R * centre, whole.R, whole.v + whole.R * whole.omega.cross(centre), whole.omega};
}

Model divided(Model model, const Parts& parts) {
    Body& first = model.bodies[static_cast<std::size_t>(parts.body)];
    Body second = first;
    const BodyState whole = first.start;
    first.mass = parts.first_mass, first.J = parts.first_J, first.start = part_state(whole, parts.first);
    second.mass = parts.second_mass, second.J = parts.second_J, second.start = part_state(whole, parts.second);
    second.name += "_part";
    const auto shift = [&](int body, Vec3& r) {
        if (body == parts.body) r -= parts.first;
    };
    for (Joint& joint : model.joints) shift(joint.first, joint.r_first), shift(joint.second, joint.r_second);
    const auto shift_points = [&](auto& forces) {
        for (auto& force : forces) shift(force.first, force.r_first), shift(force.second, force.r_second);
    };
    shift_points(model.springs), shift_points(model.polynomial_springs);
    shift_points(model.bushings), shift_points(model.attractions);
    for (Damper& damper : model.dampers) shift(damper.second, damper.r_second);
    for (Load& load : model.loads) shift(load.body, load.point);
    model.bodies.push_back(second);
    model.joints.push_back({.first = parts.body,
                            .second = static_cast<int>(model.bodies.size()) - 1,
                            .r_first = -parts.first,
                            .r_second = -parts.second,
                            .type = "fixed"});
    return model;
}

/// About the mass centre of the whole.
Action on_whole(const Action& on_part, const Vec3& arm) {
    return {on_part.force, on_part.torque + arm.cross(on_part.force)};
}

Outcome united(const Outcome& divided, const Model& model, const Parts& parts) {
    Outcome whole = divided;
    const auto i = static_cast<std::size_t>(parts.body);
    whole.bodies.pop_back();
    whole.bodies[i] = part_state(divided.bodies[i], -parts.first);
    const Vec3 first = whole.bodies[i].R * parts.first, second = whole.bodies[i].R * parts.second;
    if (whole.joints.empty()) return whole;
    whole.joints.pop_back();
    for (std::size_t j = 0; j < whole.joints.size(); ++j) {
        if (model.joints[j].first == parts.body) whole.joints[j][0] = on_whole(whole.joints[j][0], first);
        if (model.joints[j].second == parts.body) whole.joints[j][1] = on_whole(whole.joints[j][1], first);
    }
    whole.totals.pop_back();
    whole.totals[i] = on_whole(divided.totals[i], first);
    whole.totals[i].add(on_whole(divided.totals.back(), second));
    return whole;
}

}  // namespace

std::optional<Transformed> split(const Model& model) {
    int largest = ground;
    for (std::size_t i = 0; i < model.bodies.size(); ++i) {
        if (model.bodies[i].point) continue;
        if (largest == ground || model.bodies[i].J.trace() > model.bodies[static_cast<std::size_t>(largest)].J.trace())
            largest = static_cast<int>(i);
    }
    if (largest == ground) return {};
    const Parts parts = parts_of(model, largest);
    return Transformed{divided(model, parts), 1, 1, false,
                       [model, parts](const Outcome& outcome) { return united(outcome, model, parts); }};
}

}  // namespace metamorphic
}  // namespace KREISEL_PRECISION
}  // namespace kreisel
