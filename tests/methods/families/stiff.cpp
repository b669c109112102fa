// SPDX-License-Identifier: BSD-3-Clause
//
// A stiff damper, with a spring or without: what it ends at once, Radau IIA methods end at once, and Gauss methods
// carry on, with alternating signs where the number s of stages is odd, because R(-infinity) = 0 and (-1)^s
// [hairer1996].
#include <cmath>

#include "tests/methods/stepping.hpp"

using namespace kreisel;
using namespace models;
using namespace stepping;

namespace {

/// A bob of 1 kg that hangs on a rod of 1 m, held by a spring and a damper across it, stretched by 0.1 um or pushed
/// with 1 mm/s at the start.
Model held_pendulum(const Real& stiffness, const Real& damping) {
    Model model;
    Body bob{.name = "bob", .mass = 1};
    bob.J = Mat3(Vec3(2, 3, 4).asDiagonal()) / 1024;
    bob.start.x = Vec3(0, 0, -1);
    if (stiffness == 0) bob.start.v[0] = Real(1) / 1000, bob.start.omega[1] = Real(-1) / 1000;
    model.bodies = {bob};
    model.join(ground, 0, Vec3::Zero());
    Spring spring{.first = ground, .second = 0, .r_first = Vec3(1, 0, -1)};
    spring.stiffness = stiffness, spring.damping = damping;
    spring.length = stiffness == 0 ? Real(1) : 1 - Real(1) / 10000000;
    model.springs.push_back(spring);
    model.gravity.g = Vec3(0, 0, -10);
    return model;
}

/// What the spring is stretched by, or the bob's speed, over that of the start, after each of three steps of 1/16 s.
std::vector<double> decay(const Model& model, const std::string& formulation, const char* method_name) {
    Trip trip(model, formulation, method(method_name));
    const Spring& spring = model.springs[0];
    const Real h = Real(1) / 16, start = spring.stiffness == 0 ? model.bodies[0].start.v[0] : Real(1 - spring.length);
    std::vector<double> found;
    REQUIRE(trip.integrator->start(0, trip.y.data()) == Status::ok);
    for (int i = 0; i < 3; ++i) {
        INFO(method_name << " as " << formulation << ", step " << i);
        REQUIRE(trip.integrator->step(h * i, h, trip.y.data()) == Status::ok);
        const BodyState bob = trip.bodies()[0];
        const Real left = spring.stiffness == 0 ? bob.v[0] : Real((bob.x - spring.r_first).norm() - spring.length);
        found.push_back(to_double(left / start));
    }
    return found;
}

void check_that_it_ends(const std::vector<double>& x) {
    CHECK(std::abs(x[0]) <= 0.05);
    CHECK(std::abs(x[2]) <= 1e-4);
}

void check_that_it_goes_on(const std::vector<double>& x, bool alternating) {
    for (const double& one : x) CHECK(std::abs(one) >= 0.5);
    CHECK((x[0] * x[1] < 0) == alternating);
    CHECK((x[1] * x[2] < 0) == alternating);
}

}  // namespace

TEST_CASE("Radau IIA methods end at once what a stiff damper ends, and Gauss methods do not", "[methods][stiff]") {
    const Model model = held_pendulum(0, 10000);  // at 1e4 1/s
    for (const std::string& formulation : applicable(model)) {
        for (const char* name : {"rkmk/radau2a2", "rkmk/radau2a3"}) check_that_it_ends(decay(model, formulation, name));
        check_that_it_goes_on(decay(model, formulation, "rkmk/implicit_midpoint"), true);
        check_that_it_goes_on(decay(model, formulation, "rkmk/gauss2"), false);
        check_that_it_goes_on(decay(model, formulation, "rkmk/gauss3"), true);
    }
}

TEST_CASE("Radau IIA methods end the motion of a stiff spring with a damper", "[methods][stiff]") {
    const Model model = held_pendulum(100000000, 100000);  // at 1e3 and 1e5 1/s
    for (const char* formulation : {"SO3xR3", "SE3", "S3xR3"}) {
        for (const char* name : {"rkmk/radau2a2", "rkmk/radau2a3"}) check_that_it_ends(decay(model, formulation, name));
        check_that_it_goes_on(decay(model, formulation, "rkmk/implicit_midpoint"), true);
    }
}
