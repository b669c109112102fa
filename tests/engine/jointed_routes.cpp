// SPDX-License-Identifier: BSD-3-Clause
//
// The two routes on joints of every kind, springs, dampers, loads off the mass centre, driven lengths, rolling, closed
// loops and redundant rows.
#include <functional>
#include <iomanip>
#include <string>

#include "engine/reference/quaternion_form.hpp"
#include "mechanics/forces/entry.hpp"
#include "tests/engine/two_routes.hpp"
#include "tests/mechanics/models/jointed.hpp"

using namespace kreisel;
using namespace reference_tests;

namespace {

struct Case {
    std::string name;
    Model model;
};

/// Loads in both kinds of axes at points of the middle body.
Model loaded(Model model) {
    model.loads = {{1, Load::Axes::space, Vec3(3, -1, 2), Vec3(1, 0, -1), Real(1) / 4, 3, Vec3(1, 2, -1) / 4},
                   {1, Load::Axes::body, Vec3(-1, 2, 1), Vec3(0, 1, 1) / 2, Real(1) / 2, 2, Vec3(0, -1, 2) / 4}};
    return model;
}

/// A force of a type between the outer bodies, or on the last one.
Model acted_on(const ForceReader& type) {
    Model model = models::jointed("universal");
    ForceEntry entry{.first = 0, .second = 2, .r_first = Vec3(1, 0, 2) / 4, .r_second = Vec3(0, 1, -1) / 3};
    entry.distance = 1, entry.rest = Real(1) / 2, entry.stiffness = 3, entry.damping = 2;
    entry.axes_first = model.axes_of(0, axes_about(Vec3(1, 1, 3)));
    entry.axes_second = model.axes_of(2, axes_about(Vec3(1, 1, 3)));
    entry.value = Vec3(3, -1, 2), entry.point = Vec3(1, 2, -1) / 4;
    entry.amplitude = Real(1) / 4, entry.frequency = 3;
    entry.coefficients = {4, -1, Real(1) / 2};
    entry.stiffnesses = {Vec3(5, 2, 3), Vec3(1, 4, 2)}, entry.dampings = {Vec3(1, 2, 1), Vec3(1, 1, 3)};
    entry.attraction = 6, entry.mass_first = 2, entry.mass_second = 3;
    type.read(entry, model);
    return model;
}

std::vector<Case> joints() {
    std::vector<Case> cases;
    for (const JointType type : models::joint_types()) cases.push_back({type.name(), models::jointed(type)});
    return cases;
}

/// The relative difference of the routes, which is to be below 1e-25.
Real require_agreement(const Case& subject, const Real& t) {
    const ReferenceSolution first = reference_solution(subject.model, t);
    REQUIRE(first.stopped.empty());
    const Real difference = relative_difference(first, taylor(subject.model, t));
    CAPTURE(subject.name, to_double(difference));
    CHECK(difference < Real("1e-25"));
    return difference;
}

/// A joint of a driven type, and two of its kind that move as models::jointed says.
Model moved_otherwise(JointType type) {
    Model model = models::jointed(type);
    model.joints[1].turn = {{Real(1) / 8, 0, -2, Real(1) / 3}, {{Real(1) / 2, 3, 1}, {Real(1) / 5, -2, Real(1) / 2}}};
    model.joints[1].shift = {{Real(-1) / 8, 1, 1}, {{Real(1) / 4, 4, -1}}};
    project_start(model);
    return model;
}

}  // namespace

TEST_CASE("two routes agree to 25 digits on joints of every kind") {
    for (const Case& subject : joints()) require_agreement(subject, Real(1) / 4);
}

TEST_CASE("two routes agree to 25 digits on prescribed coordinates, whatever they are as functions of time") {
    for (const JointType type : models::driven_types()) {
        require_agreement({type.name(), models::jointed(type)}, 1);
        require_agreement({type.name() + std::string(", another motion"), moved_otherwise(type)}, Real(1) / 8);
    }
}

TEST_CASE("two routes agree to 25 digits after a second on screws, wheels that mesh and forces of every kind",
          "[.long]") {
    std::vector<Case> cases = {{"screw", models::jointed("screw")}, {"meshing", models::meshing()}};
    for (const JointType type : models::driven_types())
        cases.push_back({type.name() + std::string(", another motion"), moved_otherwise(type)});
    for (const ForceReader& type : Registered<ForceReader>::all())
        if (type.name != "torsion_spring") cases.push_back({type.name, acted_on(type)});
    for (const Case& one : cases)
        WARN(one.name << ": " << std::setprecision(2) << to_double(require_agreement(one, 1)));
}

TEST_CASE("a torsion spring whose axes part within a second has no reference after it", "[.long]") {
    for (const ForceReader& type : Registered<ForceReader>::all())
        if (type.name == "torsion_spring")
            CHECK(reference_solution(acted_on(type), 1).stopped == name(Status::turn_lost));
}

TEST_CASE("two routes agree to 25 digits on a shaft that turns twenty times in a second") {
    Model model = models::jointed("revolute");
    for (Joint& joint : model.joints) {
        joint.type = driven("revolute", {.turn = true});
        joint.turn = {{0, 40 * pi()}, {}};
        joint.axes_second = model.axes_of(
            joint.second, joint.first == ground ? joint.axes_first : Mat3(model.bodies[1].start.R * joint.axes_first));
    }
    project_start(model);
    require_agreement({"twenty turns a second", model}, Real(1) / 8);
}

TEST_CASE("two routes agree to 25 digits on forces of every kind") {
    require_agreement({"springs", models::sprung("universal")}, Real(1) / 4);
    require_agreement({"dampers", models::damped("distance")}, Real(1) / 4);
    require_agreement({"dampers on slides", models::damped("cylindrical")}, Real(1) / 4);
    require_agreement({"forces that bend", models::bent("universal")}, Real(1) / 4);
    require_agreement({"the same, damped", models::softened("cylindrical")}, Real(1) / 4);
    require_agreement({"loads", loaded(models::jointed("planar"))}, Real(1) / 4);
}

TEST_CASE("two routes agree to 25 digits on each force that is registered") {
    for (const ForceReader& type : Registered<ForceReader>::all())
        require_agreement({type.name, acted_on(type)}, Real(1) / 8);
}

TEST_CASE("two routes agree to 25 digits on driven lengths, a rolling disk and a closed loop") {
    require_agreement({"driven", models::driven()}, Real(1) / 4);
    require_agreement({"rolling", models::rolling()}, Real(1) / 4);
    require_agreement({"closed loop", models::closed_loop()}, Real(1) / 4);
}

TEST_CASE("two routes agree to 25 digits on redundant rows, and the reference carries no multipliers") {
    const Model model = models::hinges_in_line(0, 3);
    const ReferenceSolution both = confirmed_reference(model, Real(1) / 4);
    CHECK(both.horizon == Real(1) / 4);
    CHECK(both.multipliers.empty());
    CHECK(both.multiplier_error.force + both.multiplier_error.torque == 0);
    CHECK(relative_difference(both, taylor(model, Real(1) / 4)) < Real("1e-25"));
}

TEST_CASE("both routes know the multipliers of least norm") {
    const Model model = models::hinges_in_line(0, 3);
    QuaternionForm form(model);
    std::vector<Real> one, other;
    REQUIRE(form.multipliers(0, form.start().data(), one) == Status::ok);
    REQUIRE(TaylorRoute(model).multipliers(other) == Status::ok);
    CHECK(norm_of_difference(one, other) <
          Real("1e-27") * norm_of_difference(one, std::vector<Real>(one.size(), Real(0))));
}

TEST_CASE("control: a fault of 1e-20 in a joint, a spring or a load is seen") {
    const Real t = Real(1) / 8, small("1e-20");
    const auto agree = [&](const Model& model, const std::function<void(Model&)>& break_it) {
        Model broken = model;
        break_it(broken);
        return relative_difference(reference_solution(model, t), taylor(broken, t)) < Real("1e-23");
    };
    const Model sprung = loaded(models::damped("cylindrical"));
    CHECK(agree(sprung, [](Model&) {}));
    CHECK_FALSE(agree(sprung, [&](Model& m) { m.joints[1].axes_first(0, 2) += small; }));
    CHECK_FALSE(agree(sprung, [&](Model& m) { m.joints[0].axes_second(1, 0) += small; }));
    CHECK_FALSE(agree(sprung, [&](Model& m) { m.springs[0].stiffness += 1000 * small; }));
    CHECK_FALSE(agree(sprung, [&](Model& m) { m.springs[1].damping += 1000 * small; }));
    CHECK_FALSE(agree(sprung, [&](Model& m) { m.torsion_springs[0].angle += 1000 * small; }));
    CHECK_FALSE(agree(sprung, [&](Model& m) { m.torsion_springs[0].damping += 1000 * small; }));
    CHECK_FALSE(agree(sprung, [&](Model& m) { m.loads[0].point[1] += 1000 * small; }));
    const Model soft = models::softened("cylindrical");
    CHECK(agree(soft, [](Model&) {}));
    CHECK_FALSE(agree(soft, [&](Model& m) { m.polynomial_springs[0].coefficients[2] += 1000 * small; }));
    CHECK_FALSE(agree(soft, [&](Model& m) { m.bushings[0].stiffness[0][1] += 1000 * small; }));
    CHECK_FALSE(agree(soft, [&](Model& m) { m.bushings[0].stiffness[1][2] += 1000 * small; }));
    CHECK_FALSE(agree(soft, [&](Model& m) { m.bushings[0].damping[1][0] += 1000 * small; }));
    CHECK_FALSE(agree(soft, [&](Model& m) { m.bushings[0].axes_first(0, 2) += 1000 * small; }));
    CHECK_FALSE(agree(soft, [&](Model& m) { m.attractions[1].strength += 1000 * small; }));
    CHECK_FALSE(agree(soft, [&](Model& m) { m.dampers[1].damping += 1000 * small; }));
    CHECK_FALSE(agree(soft, [&](Model& m) { m.rotational_dampers[1].damping += 1000 * small; }));
    const Model disk = models::rolling();
    CHECK(agree(disk, [](Model&) {}));
    CHECK_FALSE(agree(disk, [&](Model& m) { m.joints[0].length += small; }));
    CHECK_FALSE(agree(models::driven(), [&](Model& m) { m.joints[1].amplitude += small; }));
    const Model driven = models::jointed(models::driven_types().back());
    CHECK(agree(driven, [](Model&) {}));
    CHECK_FALSE(agree(driven, [&](Model& m) { m.joints[1].turn.polynomial[2] += small; }));
    CHECK_FALSE(agree(driven, [&](Model& m) { m.joints[2].turn.sinusoids[0].amplitude += small; }));
    CHECK_FALSE(agree(driven, [&](Model& m) { m.joints[0].turn.sinusoids[0].frequency += small; }));
    CHECK_FALSE(agree(driven, [&](Model& m) { m.joints[1].shift.polynomial[2] += small; }));
    CHECK_FALSE(agree(driven, [&](Model& m) { m.joints[2].shift.sinusoids[0].phase += small; }));
    CHECK_FALSE(agree(models::jointed("screw"), [&](Model& m) { m.joints[1].lead += small; }));
}
