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

// x + R r of a body; r of the ground.
Vector3 place_of(const std::string& name, const Vector3& r, const Bodies& bodies) {
    if (name == "ground") { return r; }
    const ReportedBody& body = *bodies.at(name);
    Vector3 place{};
    for (std::size_t i = 0; i < 3; ++i) {
        place[i] = body.x[i].value;
        for (std::size_t j = 0; j < 3; ++j) { place[i] += body.R[3 * i + j].value * r[j]; }
    }
    return place;
}

double distance_of_points(const LinkGeometry& link, const Bodies& bodies) {
    const Vector3 a = place_of(link.between[0], link.points[0], bodies);
    const Vector3 b = place_of(link.between[1], link.points[1], bodies);
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
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
        const Geometry precise = engine_binary128().geometry(problem.name, values);
        CHECK(geometry.links.size() == precise.links.size());
        REQUIRE(geometry.bodies.size() == precise.bodies.size());
        REQUIRE(geometry.bodies.size() == state.bodies.size());
        Bodies bodies;
        for (std::size_t i = 0; i < state.bodies.size(); ++i) {
            CHECK(geometry.bodies[i].name == state.bodies[i].name);
            CHECK(geometry.bodies[i].mass > 0);
            bodies[state.bodies[i].name] = &state.bodies[i];
        }
        for (const LinkGeometry& link : geometry.links) {
            CAPTURE(link.name, link.type);
            if (link.type == "distance") { CHECK(std::abs(distance_of_points(link, bodies) - link.length) < 1e-6); }
            if (link.type != "spherical" && link.type != "revolute" && link.type != "universal") { continue; }
            CHECK(distance_of_points(link, bodies) < 1e-6);
            ++coincident;
        }
    }
    CHECK(coincident > 20);
}
