// SPDX-License-Identifier: BSD-3-Clause
//
// Mechanisms against numbers that others have published, and what they keep over 10 s. In quad fewer steps do.
#include "tests/methods/stepping.hpp"

using namespace kreisel;
using namespace models;
using namespace stepping;

namespace {

Model with(const std::string& problem_name, const ParameterValues& changes) {
    const Problem& entry = problem(problem_name);
    ParameterValues values = defaults(entry);
    for (const auto& [name, value] : changes) values[name] = value;
    return entry.build(Parameters(values));
}

Real integral(const Trip& trip, const std::string& name) {
    for (const FirstIntegral& entry : trip.system->integrals())
        if (entry.name == name) return entry.value(trip.bodies());
    throw std::out_of_range(name);
}

}  // namespace

TEST_CASE("the simple pendulum of the benchmark library ends where it is published", "[methods][published]") {
    // m = L = 1, released at rest from the horizontal; x(10), y(10) as published for a start at x = -1.
    const Model model = with("spherical_pendulum_chain", {{"masses", 1.0}, {"length", 1.0}, {"gravity", Vector3{0, -9.81, 0}}});
    for (const std::string formulation : {"SO3xR3", "SE3", "S3xR3"}) {
        INFO(formulation);
        Trip trip(model, formulation, method("rkmk/rk4"), "position_velocity");
        REQUIRE(trip.run(10, KREISEL_QUAD ? 4000 : 40000) == Status::ok);
        const Vec3 end(decimal(0.2750874625761169), decimal(-0.9614192050991251), 0);
        CHECK((trip.bodies()[0].x - end).norm() <= Real(1) / (KREISEL_QUAD ? 100000 : 1000000000));
    }
}

TEST_CASE("the energy of the four-bar is the published one", "[methods][published]") {
    for (const int N : {1, 2, 3}) {
        const Trip trip(with("four_bar", {{"windows", static_cast<double>(N)}}), "SO3xR3", method("rkmk/rk4"));
        const Real expected = Real(N + 1) / 6 + Real(N) / 2 + decimal(9.81) * (Real(N + 1) / 2 + N);
        CHECK(abs(integral(trip, "energy") - expected) <= 100 * epsilon * expected);
    }
}

TEST_CASE("closed loops hold their constraints over ten seconds when projected", "[methods][published]") {
    if (KREISEL_QUAD) return;
    for (const std::string problem_name : {"slider_crank", "bricard", "multibody"})
        for (const std::string formulation : {"SO3xR3", "SE3", "S3xR3"}) {
            INFO(problem_name << " as " << formulation);
            Trip trip(standard(problem_name), formulation, method("rkmk/rk4"), "position_velocity");
            REQUIRE(trip.run(10, 5000) == Status::ok);
            CHECK(trip.position_defect(10) <= Real(1) / 10000000000);
            CHECK(trip.velocity_defect(10) <= Real(1) / 10000000000);
        }
}

TEST_CASE("Kovalevskaya's integral is constant to the order of the method", "[methods][published]") {
    const auto error = [](long steps) {
        Trip trip(standard("kovalevskaya_top"), "SO3", method("rkmk/rk4"));
        const Real before = integral(trip, "kovalevskaya");
        REQUIRE(trip.run(2, steps) == Status::ok);
        return abs(integral(trip, "kovalevskaya") - before);
    };
    const double order = std::log2(to_double(error(400) / error(800)));
    CHECK(order >= 3.8);
    CHECK(order <= 5.3);  // invariants are often kept to one order more
}
