// SPDX-License-Identifier: BSD-3-Clause
//
// Methods that meet the constraints stay on them, of small and of large systems, and report multipliers of their own.
#include <cmath>

#include "tests/methods/implicit/for_each.hpp"

namespace implicit_on_constraints {

using namespace kreisel;
using namespace models;
using namespace stepping;

namespace {

Model resized(Model model, const Real& length, const Real& mass) {
    for (Body& body : model.bodies) {
        body.mass *= mass;
        body.J *= mass * length * length;
        body.start.x *= length, body.start.v *= length;
    }
    for (Joint& joint : model.joints) joint.r_first *= length, joint.r_second *= length;
    model.gravity.g *= length;
    return model;
}

}  // namespace

TEST_CASE("methods stay on the constraints that they meet, and report multipliers of their own from the first step on",
          "[methods]") {
    for_each_on_constraints([](const Method& entry) {
        for (const Named& named : for_methods())
            for (const std::string& formulation : applicable(named.model)) {
                if (!runs_on(entry, named.model, formulation)) continue;
                INFO(named.name << " as " << formulation);
                Trip trip(named.model, formulation, entry);
                System& s = *trip.system;
                CHECK(trip.integrator->multipliers() == nullptr);
                const Real speed = spins_fast(named.model) ? 150 : 10;
                for (int i = 0; i < 20; ++i) {
                    REQUIRE(trip.integrator->step(Real(i) / 1000, Real(1) / 1000, trip.y.data()) == Status::ok);
                    const Real t = Real(i + 1) / 1000;
                    // RATTLie's rows stand beside momenta, at whose round-off its iteration ends.
                    const bool momenta = entry.description.claims(Property::symplectic);
                    CHECK(to_double(trip.position_defect(t) / epsilon) <= (momenta ? 3000 : 1000));
                    CHECK(to_double(trip.velocity_defect(t) / (epsilon * speed)) <= 1000);
                }
                VecX dv(s.velocities()), exact(s.constraints());
                if (exact.size() == 0 || !entry.description.reports_multipliers) continue;
                REQUIRE(trip.integrator->multipliers() != nullptr);
                const Real* v = s.v(trip.y.data());
                REQUIRE(s.accelerations(Real(20) / 1000, trip.y.data(), v, dv.data(), exact.data()) == Status::ok);
                const Eigen::Map<const VecX> own(trip.integrator->multipliers(), exact.size());
                const bool coarse = spins_fast(named.model) || entry.description.order.multipliers == 1;
                CHECK((own - exact).norm() <= max(Real(1), Real(exact.norm())) / (coarse ? 10 : 1000));
            }
    });
}

TEST_CASE("methods meet the constraints of small and of large systems alike", "[methods]") {
    // Lengths in units of L metres, masses in units of m kilograms; gravity follows, so that the motion is the same.
    for_each_on_constraints([](const Method& entry) {
        for (const double length : {1.0 / 1048576, 32.0})
            for (const double mass : {1.0 / 1048576, 1048576.0}) {
                INFO("L = " << length << ", m = " << mass);
                Trip trip(resized(standard("double_pendulum"), Real(length), Real(mass)), "SO3xR3", entry);
                REQUIRE(trip.run(Real(1) / 10, 20) == Status::ok);
                CHECK(trip.position_defect() <= 1000 * epsilon * length);
                CHECK(trip.velocity_defect() <= 10000 * epsilon * length);
            }
    });
}

TEST_CASE("methods on positions alone roll a disk, whose rows at its contact have none", "[methods]") {
    if (KREISEL_QUAD) return;  // slow, and the same code
    const Model disk = standard("rolling_disk");
    const Real t_end = Real(1) / 4;
    Trip exact(disk, "SO3xR3", method("rkmk/rk4"), "velocity");
    REQUIRE(exact.run(t_end, 512) == Status::ok);
    for (const char* name : {"generalized_alpha/index3", "multistep/bliedf2_index3"}) {
        INFO(name);
        double errors[2];
        for (int i = 0; i < 2; ++i) {
            Trip trip(disk, "SO3xR3", method(name));
            REQUIRE(trip.run(t_end, 64 << i) == Status::ok);
            errors[i] = to_double(worst(distance(trip.bodies(), exact.bodies())));
        }
        CHECK(std::log2(errors[0] / errors[1]) > 1.8);
    }
}

}  // namespace implicit_on_constraints
