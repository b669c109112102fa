// SPDX-License-Identifier: BSD-3-Clause
//
// Accelerations and joint forces as Simbody finds them.
#include <catch2/catch.hpp>

#include "tests/outside/compare.hpp"
#include "tests/outside/models.hpp"
#include "tests/problems/states.hpp"

using namespace outside;

namespace {

const std::vector<std::string> of_free_bodies = {"SO3xR3", "SE3", "S3xR3"};

/// The largest difference over a model's start and random states on its joints.
Difference worst(const Model& model, const std::string& formulation, const auto& change) {
    Difference worst;
    for (const states::Pose& pose : states::poses(model, 6)) {
        const Model here = frozen(model, pose.t, pose.bodies);
        Model theirs = here;
        change(theirs);
        const Difference d = difference(here, formulation, theirs, pose.bodies);
        worst = {max(worst.state, d.state), max(worst.acceleration, d.acceleration), max(worst.reaction, d.reaction)};
    }
    return worst;
}
Difference worst(const Model& model, const std::string& formulation) {
    return worst(model, formulation, [](Model&) {});
}

void agree(const models::Named& named) {
    for (const std::string& formulation : of_free_bodies) {
        const Difference d = worst(named.model, formulation);
        CAPTURE(named.name, formulation, d.state, d.acceleration, d.reaction);
        CHECK(d.state < 1e-12);
        CHECK(d.acceleration < 1e-11);
        CHECK(d.reaction < 1e-11);
    }
}

}  // namespace

TEST_CASE("three different bodies accelerate as in Simbody, and their joints pull as hard") {
    agree({"three bodies", three_bodies()});
}

TEST_CASE("control: Simbody notices an inertia, a mass, a joint, gravity off by a millionth") {
    const Model model = three_bodies();
    const Real factor = 1 + Real(1) / 1000000;
    const auto seen = [&](const auto& change) {
        const Difference d = worst(model, "SO3xR3", change);
        CAPTURE(d.acceleration, d.reaction);
        CHECK(d.acceleration > 1e-9);
        CHECK(d.reaction > 1e-9);
    };
    for (std::size_t i = 0; i < 3; ++i) seen([&](Model& other) { other.bodies[i].J *= factor; });
    seen([&](Model& other) { other.bodies[2].mass *= factor; });
    seen([&](Model& other) { other.joints[1].r_second *= factor; });
    seen([&](Model& other) { other.gravity.g *= factor; });
}
