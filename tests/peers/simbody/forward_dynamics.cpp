// SPDX-License-Identifier: BSD-3-Clause
//
// Accelerations and joint forces as computed by Simbody.
#include <algorithm>
#include <catch2/catch.hpp>

#include "tests/peers/simbody/compare.hpp"
#include "tests/peers/simbody/models.hpp"
#include "tests/problems/states.hpp"

using namespace outside;

namespace {

const std::vector<std::string> of_free_bodies = {"SO3xR3", "SE3", "S3xR3"};

struct Worst : Difference {
    int poses = 0;
};

/// The largest difference over a model's start and random states on its joints, where Simbody is given `change(model)`.
Worst worst(const Model& model, const std::string& formulation, const auto& change) {
    Worst worst;
    for (const states::Pose& pose : states::poses(model, 12)) {
        const Model here = frozen(model, pose.t, pose.bodies);
        Model theirs = here;
        change(theirs);
        const Difference d = difference(here, formulation, theirs, pose.bodies);
        // Rows that compare axes vanish for opposite axes too; Simbody's joints know only one of the two assemblies.
        if (d.state > Real(1) / 2) continue;
        worst = {{max(worst.state, d.state), max(worst.acceleration, d.acceleration), max(worst.reaction, d.reaction)},
                 worst.poses + 1};
    }
    return worst;
}

/// Wheels push on each other, where Simbody's coupled coordinates have forces about and along the axes of their joints:
/// these carry another load.
bool joints_carry_the_same(const Model& model) {
    return std::none_of(model.joints.begin(), model.joints.end(),
                        [](const Joint& joint) { return joint.type == "gear" || joint.type == "rack"; });
}

void agree(const models::Named& named, const Real& tolerance) {
    for (const std::string& formulation : of_free_bodies) {
        const Worst d = worst(named.model, formulation, [](Model&) {});
        CAPTURE(named.name, formulation, d.poses, d.state, d.acceleration, d.reaction);
        CHECK(d.poses > 1);
        CHECK(d.state < 1e-12);
        CHECK(d.acceleration < tolerance);
        if (joints_carry_the_same(named.model)) CHECK(d.reaction < tolerance);
    }
}

}  // namespace

TEST_CASE("three different bodies accelerate as in Simbody, and their joints pull as hard") {
    agree({"three bodies", three_bodies()}, 1e-12);
}

TEST_CASE("every model that Simbody has accelerates as there, and its joints pull as hard") {
    int asked = 0;
    for (const models::Named& named : models::all())
        if (why_not(frozen(named.model, 0, starts(named.model))).empty()) agree(named, 1e-10), ++asked;
    CHECK(asked >= 45);
}

TEST_CASE("control: Simbody notices an inertia, a mass, a joint, gravity off by a millionth") {
    const Model model = three_bodies();
    const Real factor = 1 + Real(1) / 1000000;
    const auto seen = [&](const auto& change) {
        const Worst d = worst(model, "SO3xR3", change);
        CAPTURE(d.acceleration, d.reaction);
        CHECK(d.acceleration > 1e-9);
        CHECK(d.reaction > 1e-9);
    };
    for (std::size_t i = 0; i < 3; ++i) seen([&](Model& other) { other.bodies[i].J *= factor; });
    seen([&](Model& other) { other.bodies[2].mass *= factor; });
    seen([&](Model& other) { other.joints[1].r_second *= factor; });
    seen([&](Model& other) { other.gravity.g *= factor; });
}
