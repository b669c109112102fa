// SPDX-License-Identifier: BSD-3-Clause
//
// The literature's heavy top: numbers that follow from its data by hand.
#include "mechanics/integrals.hpp"
#include "mechanics/start.hpp"
#include "tests/mechanics/models/models.hpp"

using namespace kreisel;
using namespace models;

namespace {

Real digits(const char* text) { return from_text(text); }

void check_close(const Real& got, const Real& expected, const char* relative) {
    CHECK(abs(got - expected) <= digits(relative) * max(Real(1), Real(abs(expected))));
}

}  // namespace

TEST_CASE("heavy top: initial accelerations and joint force", "[mechanics]") {
    const Model model = standard("heavy_top");
    for (const char* name : {"SO3xR3", "SE3"}) {
        auto s = make_system(model, name);
        const auto y = initial_state(*s, model);
        std::vector<Real> z(12), lambda(3), dv(6);
        const Real* v = s->v(y.data());
        REQUIRE(s->accelerations(0, y.data(), v, dv.data(), lambda.data()) == Status::ok);
        check_close(dv[3], digits("661.3461692307692"), "1e-13");
        CHECK(abs(dv[4]) <= 1000 * epsilon);
        CHECK(abs(dv[5]) <= 1000 * epsilon);
        // lambda = m (x'' - g), the force of the joint on the body.
        CHECK(abs(lambda[0]) <= 1000 * epsilon);
        check_close(lambda[1], digits("-319.525988166"), "1e-11");
        check_close(lambda[2], digits("-317.262461538"), "1e-11");
        const Vec3 space =
            std::string(name) == "SE3" ? Vec3(vec3(dv.data()) + vec3(v + 3).cross(vec3(v))) : vec3(dv.data());
        check_close(space[1], digits("-21.3017325444"), "1e-11");
        check_close(space[2], digits("-30.9608307692308"), "1e-11");
    }
}

TEST_CASE("heavy top: values of its first integrals", "[mechanics]") {
    const Model model = standard("heavy_top");
    const std::vector<BodyState> start = {model.bodies[0].start};
    std::map<std::string, Real> values;
    for (const FirstIntegral& integral : first_integrals(model)) values[integral.name] = integral.value({start});
    REQUIRE(values.size() == 3);
    check_close(values.at("energy"), digits("5435.696790865547"), "1e-13");
    check_close(values.at("angular_momentum_vertical"), digits("-70.3124296875"), "1e-13");
    check_close(values.at("body_momentum"), digits("70.3125"), "1e-13");  // J_y omega_y = 0.46875 * 150
}

TEST_CASE("heavy top: a forced or asymmetric top declares fewer integrals", "[mechanics]") {
    std::vector<std::string> names;
    for (const FirstIntegral& integral : first_integrals(standard("forced_heavy_top"))) names.push_back(integral.name);
    CHECK(names == std::vector<std::string>{"angular_momentum_vertical"});
}

TEST_CASE("formulations say why they do not apply", "[mechanics]") {
    CHECK(formulation("SO3").why_not(standard("heavy_top")).empty());
    CHECK(formulation("SO3").why_not(standard("free_top")).empty());
    CHECK_THAT(formulation("SO3").why_not(standard("double_pendulum")), Catch::Contains("\"upper\""));
    CHECK_THAT(formulation("SO3").why_not(linked(2, {{0, 1}})), Catch::Contains("moving body"));
    CHECK_THAT(formulation("S3").why_not(jointed("revolute")), Catch::Contains("so S3 cannot remove them"));
}

TEST_CASE("impossible data are refused at their place", "[mechanics]") {
    const auto refused = [](const char* problem_name, const char* parameter, const ParameterValue& value) {
        ParameterValues values = defaults(problem(problem_name));
        values[parameter] = value;
        try {
            check_start(problem(problem_name).build(Parameters(values)));
        } catch (const ParameterError& error) { return error.path + ": " + error.what(); }
        return std::string("accepted");
    };
    CHECK_THAT(refused("heavy_top", "mass", 0.0), Catch::Contains("/mass: expected a positive mass"));
    CHECK_THAT(refused("heavy_top", "mass", -1.0), Catch::Contains("/mass"));
    CHECK_THAT(refused("heavy_top", "inertia", diagonal(1, 1, 3)), Catch::Contains("/inertia: no body has"));
    CHECK_THAT(refused("heavy_top", "inertia", diagonal(2, 4, 1)), Catch::Contains("/inertia: no body has"));
    CHECK_THAT(refused("heavy_top", "inertia", diagonal(1, 0, 1)), Catch::Contains("positive definite"));
    CHECK_THAT(refused("heavy_top", "R", diagonal(1, 1, -1)), Catch::Contains("/R: expected a rotation"));
    CHECK_THAT(refused("heavy_top", "R", diagonal(1, 1, 1.001)), Catch::Contains("/R: expected a rotation"));
    CHECK(refused("heavy_top", "inertia", diagonal(0.5, 0.5, 1)) == "accepted");  // a flat body: equality is fine
    CHECK(refused("free_top", "inertia", diagonal(1, 1, 3)) == "accepted");       // a warning there

    auto links = std::get<std::vector<BodyData>>(defaults(problem("double_pendulum")).at("bodies"));
    links[1].v = Vector3{0, 0, 5};
    CHECK_THAT(refused("double_pendulum", "bodies", links), Catch::Contains("joint 1 (upper - lower, spherical)"));
    links.pop_back();
    CHECK_THAT(refused("double_pendulum", "bodies", links), Catch::Contains("expected two bodies"));
}

TEST_CASE("the size of the energy is the sum of the sizes of its terms", "[mechanics]") {
    const Model model = standard("double_pendulum");
    std::vector<BodyState> states;
    Real expected = 0;
    for (const Body& body : model.bodies) {
        states.push_back(body.start);
        const Vec3 &v = body.start.v, &w = body.start.omega;
        expected += body.mass * v.dot(v) / 2 + w.dot(body.J * w) / 2;
        expected += body.mass * model.gravity.g.norm() * body.start.x.norm();
    }
    const auto system = make_system(model, "SE3");
    const FirstIntegral& energy = system->integrals().front();
    REQUIRE(energy.name == "energy");
    CHECK(abs(energy.size({states}) - expected) <= 100 * epsilon * expected);
    CHECK(abs(energy.value({states})) <= expected);
}
