// SPDX-License-Identifier: BSD-3-Clause
//
// Any mechanism: rigid bodies and point masses, joints of every kind (mechanics/joints/joint_rows.hpp), springs and
// loads (mechanics/forces/), gravity g (1 + A sin(W t)). Velocities that are not given follow from the joints. The
// model holds what the config says and nothing else. The demonstration is a crank that turns about the y axis, with a
// rod on a spherical joint at its end, which a spring holds; the data are our own.
#include <algorithm>

#include "lie/so3.hpp"
#include "mechanics/formulation.hpp"
#include "mechanics/start.hpp"
#include "mechanics/start/positions.hpp"
#include "problems/problem.hpp"
#include "problems/reading/bodies.hpp"
#include "problems/reading/forces.hpp"
#include "problems/reading/joints.hpp"
#include "problems/reading/parts.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// `"crank" by 0.01 m, 0.2 rad, 0 m/s, 0 rad/s`.
std::string change_of(const Body& body, const BodyState& old) {
    using reading::text;
    const Real turn = SO3::log(old.R.transpose() * body.start.R).norm();
    return "\"" + body.name + "\" by " + text((body.start.x - old.x).norm()) + " m, " + text(turn) + " rad, " +
           text((body.start.v - old.v).norm()) + " m/s, " + text((body.start.omega - old.omega).norm()) + " rad/s";
}

/// Moves the start onto the joints and reports by how much, unless that is round-off: the largest changes, and those of
/// the first bodies.
void project(Model& model) {
    using reading::text;
    constexpr std::size_t most_bodies = 20;
    const std::vector<Body> before = model.bodies;
    const StartCorrection moved = project_start(model);
    if (moved.noise) return;
    std::string report = "project_initial moved bodies by up to " + text(moved.position) + " m and " +
                         text(moved.rotation) + " rad, and changed velocities by up to " + text(moved.velocity) +
                         " m/s and " + text(moved.omega) + " rad/s";
    for (std::size_t i = 0; i < std::min(most_bodies, before.size()); ++i)
        report += (i == 0 ? ": " : "; ") + change_of(model.bodies[i], before[i].start);
    if (before.size() > most_bodies) report += "; and so on";
    model.warnings.push_back(report);
}

/// Velocities that are not given, with axes as they will lie: where they are at right angles, rows have no derivative.
void complete_velocities_to_project(Model& model, const GivenVelocities& given) {
    Model aligned = with_aligned_axes(model);
    complete_velocities(aligned, given);
    model.warnings = aligned.warnings;
    for (std::size_t i = 0; i < model.bodies.size(); ++i) {
        model.bodies[i].start.v = aligned.bodies[i].start.v;
        model.bodies[i].start.omega = aligned.bodies[i].start.omega;
    }
}

Model multibody(const Parameters& p) {
    const bool projected = p.flag("project_initial");
    Model model;
    read_bodies(model, p.bodies("bodies"));
    read_joints(model, p.joints("joints"), projected);
    read_forces(model, p.forces("forces"));
    model.gravity = {p.vector("gravity"), p.scalar("gravity_amplitude"), p.scalar("gravity_frequency")};
    const GivenVelocities given = given_velocities(p.bodies("bodies"));
    if (!projected) {
        complete_velocities(model, given);
        return model;
    }
    complete_velocities_to_project(model, given);
    project(model);
    return model;
}

std::vector<BodyData> crank_and_rod() {
    return {{.name = "crank",
             .mass = 1.2,
             .inertia = diagonal(0.004, 0.03, 0.032),
             .x = {0.3, 0, 0},
             .omega = Vector3{0, 2, 0}},
            {.name = "rod",
             .mass = 0.8,
             .inertia = diagonal(0.003, 0.05, 0.051),
             .x = {0.6, 0.4, 0},
             .R = {0, -1, 0, 1, 0, 0, 0, 0, 1},
             .omega = Vector3{1, 0.5, -0.7}}};
}

std::vector<JointData> pivot_and_ball() {
    const Vector3 origin = {0, 0, 0}, end = {0.6, 0, 0}, y = {0, 1, 0};
    return {{.type = "revolute", .between = {"ground", "crank"}, .points = {origin, origin}, .axes = {y, y}},
            {.type = "spherical", .between = {"crank", "rod"}, .points = {end, end}}};
}

std::vector<ForceData> one_spring() {
    const Vector3 hook = {0.6, 0.8, 0.9}, end = {0.6, 0.8, 0};
    return {
        ForceData{.type = "spring", .between = {"ground", "rod"}, .points = {hook, end}, .stiffness = 25, .rest = 0.7}};
}

}  // namespace

KREISEL_PROBLEM(
    multibody,
    {.name = "multibody",
     .summary = "any mechanism: bodies, joints and forces as parameters",
     .cites = {},
     .parameters =
         {{"bodies", ParameterKind::bodies, "", "rigid bodies and point masses", std::vector<BodyData>(), true},
          {"joints", ParameterKind::joints, "", "what holds bodies to each other or to the ground",
           std::vector<JointData>()},
          {"forces", ParameterKind::forces, "", "springs, dampers, attractions and loads", std::vector<ForceData>()},
          {"gravity", ParameterKind::vector, "m/s^2", "gravity, space axes", Vector3{0, 0, -9.81}},
          {"gravity_amplitude", ParameterKind::scalar, "1", "A in gravity (1 + A sin(W t))", 0.0},
          {"gravity_frequency", ParameterKind::scalar, "rad/s", "W in gravity (1 + A sin(W t))", 0.0},
          {"project_initial", ParameterKind::flag, "", "move the start onto the joints, and say by how much", false}},
     .demonstration = {{"bodies", crank_and_rod()}, {"joints", pivot_and_ball()}, {"forces", one_spring()}},
     .demonstration_config = "experiments/mechanisms/crank_and_rod.json"});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
