// SPDX-License-Identifier: BSD-3-Clause
//
// What joints exert: by hand for bodies at rest, and by Newton's and Euler's laws for moving bodies.
#include "mechanics/joints/joint_rows.hpp"
#include "mechanics/parts/driven_joints.hpp"
#include "mechanics/solve/forest.hpp"
#include "mechanics/start.hpp"
#include "tests/mechanics/models/models.hpp"

using namespace kreisel;
using namespace models;

namespace {

struct Answered {
    std::vector<BodyState> states;
    std::vector<Vec3> acceleration, turning;  // x'' in space axes, omega' in body axes
    VecX lambda;
    std::vector<JointReaction> reactions;
};

/// Of a system in coordinates whose v' is (x'', omega').
Answered answered(System& s, const Model& model, const Real& t) {
    const auto y = initial_state(s, model);
    const Real *q = y.data(), *v = s.v(q);
    Answered out;
    VecX dv(s.velocities());
    out.lambda.resize(s.constraints());
    REQUIRE(s.accelerations(t, q, v, dv.data(), out.lambda.size() > 0 ? out.lambda.data() : nullptr) == Status::ok);
    out.states.resize(model.bodies.size()), out.reactions.resize(model.joints.size());
    s.read(q, out.states.data());
    REQUIRE(s.reactions(t, q, v, out.lambda.data(), out.reactions.data()) == Status::ok);
    for (Eigen::Index i = 0; s.mass_block() == 6 && i < dv.size(); i += 6)
        out.acceleration.push_back(dv.segment<3>(i)), out.turning.push_back(dv.segment<3>(i + 3));
    return out;
}

/// The point of the second body about which its torque is given, in space axes.
Vec3 joint_point(const Joint& joint, const std::vector<BodyState>& states) {
    if (joint.second == ground) return joint.r_second;
    const BodyState& body = states[static_cast<std::size_t>(joint.second)];
    const Vec3 p = body.x + body.R * joint.r_second;
    if (joint.type != "rolling") return p;
    const Vec3 n = joint.axes_first.col(2), b = body.R * joint.axes_second.col(2);
    return p - joint.length * (n - n.dot(b) * b).normalized();
}

/// The axis of the second body, in space axes.
Vec3 axis_of(const Joint& joint, const std::vector<BodyState>& states) {
    const Vec3 axis = joint.axes_second.col(2);
    return joint.second == ground ? axis : Vec3(states[static_cast<std::size_t>(joint.second)].R * axis);
}

/// Largest relative residual of m x'' = F and J omega' + omega x J omega = tau about its mass centre.
Real newton_euler_defect(const Model& model, const Answered& now, const Real& t) {
    const std::size_t n = model.bodies.size();
    std::vector<Vec3> force(n, Vec3::Zero()), torque = force;
    std::vector<Real> size(n, Real(1));
    const auto add = [&](int body, const Vec3& f, const Vec3& tau, const Vec3& point) {
        if (body == ground) return;
        const auto i = static_cast<std::size_t>(body);
        const Vec3 moment = tau + (point - now.states[i].x).cross(f);
        force[i] += f, torque[i] += moment, size[i] += f.norm() + moment.norm();
    };
    for (std::size_t j = 0; j < model.joints.size(); ++j) {
        const Joint& joint = model.joints[j];
        const Vec3 axis = axis_of(joint, now.states), point = joint_point(joint, now.states);
        const Vec3 f = now.reactions[j].force + now.reactions[j].driving_force * axis;
        const Vec3 tau = now.reactions[j].torque + now.reactions[j].driving_torque * axis;
        add(model.joints[j].second, f, tau, point), add(model.joints[j].first, -f, -tau, point);
    }
    const auto motion = [&](int body) -> Motion {
        if (body == ground) return {};
        const BodyState& s = now.states[static_cast<std::size_t>(body)];
        return {s.x, s.R, s.R.transpose() * s.v, s.omega};
    };
    const auto within_half_a_turn = [](std::size_t, const Turn& turn) { return turn.principal; };
    for_each_wrench(model, t, motion, within_half_a_turn, [&](int body, const Wrench& w) {
        const BodyState& s = now.states[static_cast<std::size_t>(body)];
        add(body, s.R * w.force, s.R * w.torque, s.x);
    });
    Real worst = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const Body& body = model.bodies[i];
        const BodyState& s = now.states[i];
        const Vec3 f = force[i] - body.mass * (now.acceleration[i] - model.gravity.at(t));
        const Vec3 tau = s.R.transpose() * torque[i] - body.J * now.turning[i] - s.omega.cross(body.J * s.omega);
        worst = max(worst, Real(max(Real(f.norm()), Real(body.point ? 0 : tau.norm())) / size[i]));
    }
    return worst;
}

/// The two bodies of a joint in the other order.
Joint reversed(Joint joint) {
    std::swap(joint.first, joint.second), std::swap(joint.r_first, joint.r_second);
    std::swap(joint.axes_first, joint.axes_second);
    return joint;
}

std::vector<Named> in_both_orders() {
    std::vector<Named> named = all();
    for (const JointType type : joint_types()) {
        named.push_back({std::string("reversed ") + type.name(), damped(type)});
        for (Joint& joint : named.back().model.joints) joint = reversed(joint);
    }
    for (const JointType type : {"prismatic", "cylindrical", "planar"}) {
        Model model = damped(type);  // the points displaced along the free directions of the joint
        for (Joint& joint : model.joints) joint.r_first += joint.axes_first.col(type == "planar" ? 0 : 2);
        project_start(model);
        named.push_back({std::string("slid ") + type.name(), model});
        for (Joint& joint : model.joints) joint = reversed(joint);
        named.push_back({std::string("reversed, slid ") + type.name(), model});
    }
    named.push_back({"two hinges in line", hinges_in_line(0, 2)});
    return named;
}

Real reactions_tolerance(const System& s) {
    const Real condition = s.constraint_rank().condition.value_or(1);
    return (4000 + 10 * condition * condition) * epsilon;
}

}  // namespace

TEST_CASE("reactions and loads satisfy the Newton-Euler equations of each body, on every path", "[reactions]") {
    const Real t = Real(3) / 10;
    int judged = 0;
    for (const Named& named : in_both_orders()) {
        INFO(named.name);
        std::vector<std::unique_ptr<System>> systems;
        for (const SolverChoice choice : {SolverChoice::dense, SolverChoice::graph, SolverChoice::sparse})
            systems.push_back(general_system(named.model, "SO3xR3", choice));
        const Real tolerance = reactions_tolerance(*systems[0]);
        if (takes_recursion(named.model)) systems.push_back(make_system(named.model, "SO3xR3"));
        for (const auto& system : systems) {
            const Answered now = answered(*system, named.model, t);
            CHECK(newton_euler_defect(named.model, now, t) <= tolerance);
            ++judged;
        }
    }
    CHECK(judged > 150);
}

TEST_CASE("a reaction on the wrong body or about the wrong point is noticed", "[reactions]") {
    const Model model = damped("prismatic");
    const auto system = general_system(model, "SO3xR3");
    const Answered good = answered(*system, model, 0);
    for (std::size_t j = 0; j < model.joints.size(); ++j) {
        Answered bad = good;
        bad.reactions[j].force *= -1, bad.reactions[j].torque *= -1;
        CHECK(newton_euler_defect(model, bad, 0) > Real(1) / 100);
        bad = good;
        bad.reactions[j].torque += Vec3(1, 2, -1).cross(bad.reactions[j].force);
        CHECK(newton_euler_defect(model, bad, 0) > Real(1) / 100);
    }
}

TEST_CASE("reactions are the same in every formulation", "[reactions]") {
    for (const Named& named : in_both_orders()) {
        if (!has_independent_rows(named.model)) continue;
        INFO(named.name);
        const auto reference = make_system(named.model, "SO3xR3");
        const Answered expected = answered(*reference, named.model, Real(1) / 4);
        const Real tolerance = reactions_tolerance(*reference);
        for (const std::string& formulation : applicable(named.model)) {
            INFO(formulation);
            const auto system = make_system(named.model, formulation);
            const Answered now = answered(*system, named.model, Real(1) / 4);
            for (std::size_t j = 0; j < named.model.joints.size(); ++j) {
                const JointReaction &a = now.reactions[j], &b = expected.reactions[j];
                const Real size = 1 + b.force.norm() + b.torque.norm() + expected.lambda.norm();
                CHECK((a.force - b.force).norm() <= tolerance * size);
                CHECK((a.torque - b.torque).norm() <= tolerance * size);
                CHECK(abs(a.driving_force - b.driving_force) <= tolerance * size);
                CHECK(abs(a.driving_torque - b.driving_torque) <= tolerance * size);
            }
        }
    }
}

namespace {

/// A body of 2 kg at `centre` that a joint of its axes holds at rest against gravity (0, 0, -10) and a torque.
Model at_rest(JointType type, const Vec3& point, const Vec3& axis, const Vec3& centre, const Vec3& torque,
              bool other_order) {
    Model model;
    model.bodies.push_back({.name = "b", .mass = 2});
    model.bodies[0].start.x = centre;
    model.join(ground, 0, point, type, axis);
    Joint& joint = model.joints[0];
    if (type == "universal") joint.axes_second = axes_about(axis.cross(Vec3::UnitZ()));
    if (type == "distance") joint.r_second = Vec3::Zero(), joint.length = (point - centre).norm();
    if (type == "rolling")
        joint.r_first.setZero(), joint.r_second.setZero(), joint.axes_first.setIdentity(), joint.length = centre[2];
    if (other_order) joint = reversed(joint);
    model.gravity.g = Vec3(0, 0, -10);
    model.loads.push_back({.body = 0, .torque = torque});
    return model;
}

struct AtRest {
    JointType type;
    Vec3 point, axis, centre, torque;  ///< the joint's point and axis, the mass centre, a torque from outside
    Vec3 joint_torque;                 ///< on the body about the joint's point
};

}  // namespace

TEST_CASE("joints hold a body at rest with its weight and its moment", "[reactions]") {
    const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ(), o = Vec3::Zero();
    const AtRest cases[] = {
        {"spherical", 2 * z, z, o, o, o},
        {"revolute", o, x, x / 2, o, Vec3(0, -10, 0)},  // the weight turns about +y, the hinge against it
        {"revolute", o, y, o, 3 * x - 4 * z, -3 * x + 4 * z},
        {"universal", o, x, o, 3 * z, -3 * z},  // axes x and -y
        {"prismatic", o, x, 3 * y, Vec3(1, 2, 3), Vec3(-1 + 60, -2, -3)},
        {"cylindrical", o, x, 2 * x, Vec3(0, 2, 3), Vec3(0, -2 - 40, -3)},
        {"planar", o, z, 2 * x, Vec3(4, 5, 0), Vec3(-4, -5 - 40, 0)},
        {"fixed", o, z, Vec3(2, 3, 4), Vec3(1, 2, 3), Vec3(-1 + 60, -2 - 40, -3)},
        {"distance", 3 * z, z, o, o, o},
        {"rolling", o, y, 2 * z, o, o}};
    for (const AtRest& one : cases)
        for (const bool other_order : {false, true}) {
            if (other_order && one.type == "rolling") continue;
            INFO(one.type.name() << (other_order ? ", ground second" : ""));
            const Model model = at_rest(one.type, one.point, one.axis, one.centre, one.torque, other_order);
            const auto system = general_system(model, "SO3xR3");
            const Answered now = answered(*system, model, 0);
            const Real sense = other_order ? -1 : 1, tolerance = 10000 * epsilon;
            CHECK(now.acceleration[0].norm() + now.turning[0].norm() <= tolerance);
            CHECK((now.reactions[0].force - sense * Vec3(0, 0, 20)).norm() <= tolerance);
            CHECK((now.reactions[0].torque - sense * one.joint_torque).norm() <= tolerance);
        }
}

TEST_CASE("a distance joint pulls with a positive multiplier, in either order", "[reactions]") {
    for (const bool other_order : {false, true})
        for (const int side : {1, -1}) {  // a rod from above, and one from below
            const Model model =
                at_rest("distance", Vec3(0, 0, 3 * side), Vec3::UnitZ(), Vec3::Zero(), Vec3::Zero(), other_order);
            const auto system = general_system(model, "SO3xR3");
            CHECK(abs(answered(*system, model, 0).lambda[0] - 20 * side) <= 100 * epsilon);
        }
}

namespace {

/// dE/dt of kinetic energy and weight.
Real energy_rate(const Model& model, const Answered& now) {
    Real sum = 0;
    for (std::size_t i = 0; i < model.bodies.size(); ++i) {
        const Body& body = model.bodies[i];
        const BodyState& s = now.states[i];
        sum += body.mass * s.v.dot(now.acceleration[i] - model.gravity.g) + s.omega.dot(body.J * now.turning[i]);
    }
    return sum;
}

/// What the drives of all joints do in a second, with `factor` times their torques.
Real power(const Model& model, const Answered& now, const Real& factor) {
    Real sum = 0;
    for (std::size_t j = 0; j < model.joints.size(); ++j)
        sum += now.reactions[j].driving_force * model.joints[j].shift.at(0).rate +
               factor * now.reactions[j].driving_torque * model.joints[j].turn.at(0).rate;
    return sum;
}

/// A driven model under constant gravity.
Model on_drives(JointType type) {
    Model model = jointed(type);
    model.gravity.amplitude = 0;
    return model;
}

}  // namespace

TEST_CASE("energy grows by what the drives of joints do, and by nothing else", "[reactions][driven]") {
    for (const JointType type : driven_types()) {
        INFO(type.name());
        const Model model = on_drives(type);
        const auto system = general_system(model, "SO3xR3");
        const Answered now = answered(*system, model, 0);
        const Real rate = energy_rate(model, now), tolerance = 1000000 * epsilon * (1 + abs(rate));
        CHECK(abs(rate) > 1);
        CHECK(abs(rate - power(model, now, 1)) <= tolerance);
        if (type->has(Primitive::turn)) CHECK(abs(rate - power(model, now, 2)) > 1000 * tolerance);
    }
    const Model screws = on_drives("screw");
    const auto system = general_system(screws, "SO3xR3");
    CHECK(abs(energy_rate(screws, answered(*system, screws, 0))) <= 1000000 * epsilon);
}

TEST_CASE("a motor holds a beam against its weight, the hinge the rest", "[reactions][driven]") {
    for (const bool other_order : {false, true}) {
        Model model = at_rest("revolute", Vec3::Zero(), Vec3::UnitY(), Vec3::UnitX() / 2, Vec3(3, 0, 0), other_order);
        model.joints[0].type = driven("revolute", {.turn = true});
        const auto system = general_system(model, "SO3xR3");
        const Answered now = answered(*system, model, 0);
        const Real sense = other_order ? -1 : 1, tolerance = 10000 * epsilon;
        CHECK(abs(now.reactions[0].driving_torque + sense * 10) <= tolerance);
        CHECK((now.reactions[0].torque - sense * Vec3(-3, 0, 0)).norm() <= tolerance);
        CHECK((now.reactions[0].force - sense * Vec3(0, 0, 20)).norm() <= tolerance);
        CHECK(now.acceleration[0].norm() + now.turning[0].norm() <= tolerance);
    }
}

TEST_CASE("a prescribed turn has no second place half a turn away", "[driven]") {
    Model model = at_rest("revolute", Vec3::Zero(), Vec3::UnitY(), Vec3::UnitX() / 2, Vec3::Zero(), false);
    model.joints[0].type = driven("revolute", {.turn = true});
    const Joint& joint = model.joints[0];
    for (const int degrees : {0, 30, 89, 91, 150, 180, 270, 720, 790}) {
        const Real f = degrees * pi() / 180;
        model.joints[0].turn = {{f}, {}};
        Motion turned;
        turned.R = SO3::exp(f * Vec3::UnitY()), turned.x = turned.R * model.bodies[0].start.x;
        JointRows rows;
        write_rows(joint, 0, Motion(), turned, rows);
        CHECK(abs(rows.phi[5]) <= 1000 * epsilon);
        Motion away = turned;
        away.R = SO3::exp((f + 3) * Vec3::UnitY()), away.x = away.R * model.bodies[0].start.x;
        write_rows(joint, 0, Motion(), away, rows);
        CHECK(abs(rows.phi[5] + 3) <= 1000 * epsilon);
    }
}

TEST_CASE("a body is projected to where a joint's motion begins, up to half a turn away", "[start][driven]") {
    for (const int degrees : {-170, -90, 80, 120, 175}) {
        INFO(degrees);
        Model model = at_rest("revolute", Vec3::Zero(), Vec3::UnitY(), Vec3::UnitX() / 2, Vec3::Zero(), false);
        model.joints[0].type = driven("revolute", {.turn = true});
        const Real f = degrees * pi() / 180;
        model.joints[0].turn = {{f, 2}, {}};
        project_start(model);
        CHECK((model.bodies[0].start.R - SO3::exp(f * Vec3::UnitY())).norm() <= 10000 * epsilon);
        CHECK((model.bodies[0].start.omega - 2 * Vec3::UnitY()).norm() <= 10000 * epsilon);
    }
}
