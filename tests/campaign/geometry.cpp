// SPDX-License-Identifier: BSD-3-Clause
//
// The geometry of every problem: with the poses of its bodies, points of joints lie where the joints say.
#include <catch2/catch.hpp>
#include <cmath>
#include <map>

#include "engine/engine.hpp"

using namespace kreisel;

namespace {

using Bodies = std::map<std::string, const ReportedBody*>;

// R a of a body; a of the ground.
Vector3 direction_of(const std::string& name, const Vector3& a, const Bodies& bodies) {
    if (name == "ground") { return a; }
    const ReportedBody& body = *bodies.at(name);
    Vector3 direction{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) { direction[i] += body.R[3 * i + j].value * a[j]; }
    }
    return direction;
}

// x + R r of a body; r of the ground.
Vector3 place_of(const std::string& name, const Vector3& r, const Bodies& bodies) {
    Vector3 place = direction_of(name, r, bodies);
    if (name == "ground") { return place; }
    for (std::size_t i = 0; i < 3; ++i) { place[i] += bodies.at(name)->x[i].value; }
    return place;
}

double distance_of(const Vector3& a, const Vector3& b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

double distance_of_points(const LinkGeometry& link, const Bodies& bodies) {
    return distance_of(place_of(link.between[0], link.points[0], bodies),
                       place_of(link.between[1], link.points[1], bodies));
}

double distance_of_axes(const LinkGeometry& link, const Bodies& bodies) {
    return distance_of(direction_of(link.between[0], link.axes.at(0), bodies),
                       direction_of(link.between[1], link.axes.at(1), bodies));
}

// Relative to the size of both.
void agree(const Vector3& a, const Vector3& b) {
    CHECK(distance_of(a, b) <= 1e-14 * (1 + distance_of(a, Vector3{}) + distance_of(b, Vector3{})));
}

void agree(const LinkGeometry& a, const LinkGeometry& b) {
    CAPTURE(a.name);
    CHECK(a.name == b.name);
    CHECK(a.type == b.type);
    CHECK(a.between == b.between);
    CHECK(a.length == Approx(b.length).epsilon(1e-14).margin(0));
    for (std::size_t i = 0; i < 2; ++i) { agree(a.points[i], b.points[i]); }
    REQUIRE(a.axes.size() == b.axes.size());
    for (std::size_t i = 0; i < a.axes.size(); ++i) { agree(a.axes[i], b.axes[i]); }
}

void agree(const Geometry& a, const Geometry& b) {
    REQUIRE(a.bodies.size() == b.bodies.size());
    for (std::size_t i = 0; i < a.bodies.size(); ++i) {
        CHECK(a.bodies[i].name == b.bodies[i].name);
        CHECK(a.bodies[i].mass == Approx(b.bodies[i].mass).epsilon(1e-14).margin(0));
    }
    REQUIRE(a.links.size() == b.links.size());
    for (std::size_t i = 0; i < a.links.size(); ++i) { agree(a.links[i], b.links[i]); }
}

// A state a little after the start.
ReportedState state_of(const ProblemDescription& problem, const ParameterValues& values) {
    const Engine& engine = engine_binary64();
    Cell cell;
    cell.problem = problem.name, cell.parameters = values, cell.formulation = "SO3xR3", cell.method = "rkmk/rk4";
    cell.options = {{"coordinates", std::string("exp")}, {"dexpinv", std::string("exact")}};
    cell.projection = "none", cell.t_end = 1e-6, cell.steps = 1;
    const Outcome outcome = engine.run(cell, nullptr, {});
    REQUIRE(outcome.status == "ok");
    return *outcome.final;
}

}  // namespace

TEST_CASE("the geometry of every problem fits the poses of its bodies", "[campaign]") {
    const Engine& engine = engine_binary64();
    int coincident = 0;
    for (const ProblemDescription& problem : engine.problems()) {
        CAPTURE(problem.name);
        const ParameterValues values = demonstration_parameters(problem);
        const ReportedState state = state_of(problem, values);
        const Geometry geometry = engine.geometry(problem.name, values);
        agree(geometry, engine_binary128().geometry(problem.name, values));
        REQUIRE(geometry.bodies.size() == state.bodies.size());
        Bodies bodies;
        for (std::size_t i = 0; i < state.bodies.size(); ++i) {
            CHECK(geometry.bodies[i].name == state.bodies[i].name);
            CHECK(geometry.bodies[i].mass > 0);
            bodies[state.bodies[i].name] = &state.bodies[i];
        }
        for (const LinkGeometry& link : geometry.links) {
            CAPTURE(link.name, link.type);
            if (link.type == "revolute") { CHECK(distance_of_axes(link, bodies) < 1e-6); }
            if (link.type == "distance") { CHECK(std::abs(distance_of_points(link, bodies) - link.length) < 1e-6); }
            if (link.type != "spherical" && link.type != "revolute" && link.type != "universal") { continue; }
            CHECK(distance_of_points(link, bodies) < 1e-6);
            ++coincident;
        }
    }
    CHECK(coincident > 20);
}
