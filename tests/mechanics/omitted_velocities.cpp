// SPDX-License-Identifier: BSD-3-Clause
//
// Velocities that are not given, v and omega, from the joints and what is given.
#include "mechanics/start.hpp"
#include "tests/mechanics/models/models.hpp"

using namespace kreisel;
using namespace models;

namespace {

using Catch::Contains;

GivenVelocities nothing(const Model& model) {
    const std::vector<bool> none(model.bodies.size(), false);
    return {none, none};
}

Real kinetic_energy(const Model& model) {
    Real sum = 0;
    for (const Body& body : model.bodies)
        sum += (body.mass * body.start.v.squaredNorm() + body.start.omega.dot(body.J * body.start.omega)) / 2;
    return sum;
}

Real distance_of_velocities(const Model& a, const Model& b) {
    Real worst = 0;
    for (std::size_t i = 0; i < a.bodies.size(); ++i) {
        worst = max(worst, Real((a.bodies[i].start.v - b.bodies[i].start.v).norm()));
        worst = max(worst, Real((a.bodies[i].start.omega - b.bodies[i].start.omega).norm()));
    }
    return worst;
}

/// The model as it is completed from the omega of one body.
Model from_omega_of(std::size_t body, const Model& whole) {
    Model model = whole;
    model.warnings.clear();
    GivenVelocities given = nothing(model);
    given.omega[body] = true;
    complete_velocities(model, given);
    return model;
}

std::string objection_to(const Model& model) {
    try {
        check_start(model);
    } catch (const ParameterError& error) { return error.what(); }
    return "";
}

}  // namespace

TEST_CASE("a mechanism with one degree of freedom starts from the speed of one body", "[start]") {
    const Model whole = standard("slider_crank");
    for (std::size_t i = 0; i < whole.bodies.size(); ++i) {
        if (whole.bodies[i].start.omega.isZero(0)) continue;  // the slider
        CAPTURE(whole.bodies[i].name);
        const Model model = from_omega_of(i, whole);
        CHECK(distance_of_velocities(model, whole) < 100000 * epsilon * (1 + sqrt(kinetic_energy(whole))));
        CHECK(model.warnings.empty());
        CHECK(objection_to(model) == "");
    }
}

TEST_CASE("a mechanism of which nothing is given rests, and nothing is said of it", "[start]") {
    for (const char* name : {"slider_crank", "four_bar", "double_pendulum", "free_top"}) {
        Model model = standard(name);
        model.warnings.clear();
        complete_velocities(model, nothing(model));
        CHECK(kinetic_energy(model) == 0);
        CHECK(model.warnings.empty());
    }
}

TEST_CASE("what the joints leave free is taken of least kinetic energy, with a warning", "[start]") {
    const Model whole = standard("double_pendulum");
    const Model model = from_omega_of(0, whole);
    CHECK(model.bodies[0].start.omega == whole.bodies[0].start.omega);
    CHECK(objection_to(model) == "");
    REQUIRE(model.warnings.size() == 1);
    CHECK_THAT(model.warnings[0], Contains("leave 3 directions free in the velocities of \"lower\": those of least"));
    const Real least = kinetic_energy(model);
    for (Eigen::Index k = 0; k < 3; ++k)
        for (const int sign : {-1, 1}) {
            Model other = model;
            other.bodies[1].start.omega[k] += Real(sign) / 100;
            complete_velocities(other, {{false, false}, {true, true}});
            CHECK(objection_to(other) == "");
            CHECK(kinetic_energy(other) > least);
        }
}

TEST_CASE("given numbers that contradict each other are an error that names the joints", "[start]") {
    Model model = standard("slider_crank");
    GivenVelocities given = nothing(model);
    const std::size_t slider = model.bodies.size() - 1;
    given.omega[0] = given.v[slider] = true;
    model.bodies[slider].start.v *= 2;
    complete_velocities(model, given);
    CHECK_THAT(objection_to(model), Contains("joint") && Contains(model.bodies[slider].name));
}
