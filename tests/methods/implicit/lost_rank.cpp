// SPDX-License-Identifier: BSD-3-Clause
//
// Implicit methods where a mechanism loses rank, and beside.
#include "tests/methods/implicit/for_each.hpp"

namespace implicit_lost_rank {

using namespace kreisel;
using namespace models;
using namespace stepping;
using namespace linkages;

namespace {

/// Turns at 1 rad/s; at pi/2 all bars lie in a line. With one window in quad, which is slow.
Model parallelogram() {
    ParameterValues values = defaults(problem("four_bar"));
    values["windows"] = KREISEL_QUAD ? 1.0 : 2.0;
    values["gravity"] = Vector3{0, 0, 0};
    return problem("four_bar").build(Parameters(values));
}

Real spin_error(const Trip& trip) { return abs(abs(trip.bodies()[0].omega[2]) - 1); }

/// A method of order 1 has lost 1.7 % after 64 steps. A step by the angle a takes the share a^2/2 from velocities along
/// the circle at its end, 1 - cos(a), and where these are chords twice that, 1 - cos(3a/2)/cos(a/2).
Real least_spin_error(const Method& entry) {
    if (entry.description.order.velocity > 1) return Real(1) / 5000;
    const bool chords = entry.description.meets_positions && !entry.description.meets_velocities;
    return Real(1) / (chords ? 25 : 50);
}

}  // namespace

TEST_CASE("a step that ends beside the pose where a linkage loses rank is right, in every unit", "[methods]") {
    for (const Real& length : {Real(1), Real(1) / 1048576})
        for (const Real& distance : {Real(1) / 100, Real(1) / 1000, Real(1) / 10000}) {
            if (KREISEL_QUAD && (length != 1 || distance != Real(1) / 1000)) continue;  // slow, and the same code
            for_each_implicit([&](const Method& entry) {
                INFO("lengths times " << length << ", " << distance << " rad beside it");
                const bool own = !entry.description.projectable || entry.description.meets_constraints();
                Trip trip(in_units(parallelogram(), length, 1), "SO3xR3", entry, own ? "none" : "position_velocity");
                const Status status = trip.run(pi() / 2 - distance, 64);
                // This near it depends on the steps whether the iteration gets there: with 64 that of bliedf3 does not,
                // with 128 that of index2.
                if (status == Status::newton_failed && distance < Real(1) / 1000) return;
                REQUIRE(status == Status::ok);
                CHECK(spin_error(trip) < least_spin_error(entry));
                CHECK(trip.position_defect() <= Real(1) / 1000000);  // rows of directions are among them
            });
        }
}

TEST_CASE("a step that ends where a linkage loses rank says so, in every unit", "[methods]") {
    const Model one = parallelogram();
    for (const Real& length : {Real(1), Real(1) / 1048576}) {
        if (KREISEL_QUAD && length != 1) continue;  // slow, and the same code
        for_each_implicit([&](const Method& entry) {
            if (!entry.description.meets_constraints()) return;
            Trip trip(in_units(one, length, 1), "SO3xR3", entry);
            const Status status = trip.run(pi() / 2, 64);
            INFO(name(status));
            if (status == Status::ok) {  // its own error has led beside it: then the motion must be right
                CHECK(spin_error(trip) < least_spin_error(entry));
                return;
            }
            CHECK(status != Status::ok);
            CHECK(trip.system->reason(status).find("rank") != std::string::npos);
            CHECK(trip.system->reason(status).find("joint") != std::string::npos);
        });
    }
}

TEST_CASE("a step without a solution beside the pose where a linkage loses rank names the joints", "[methods]") {
    if (KREISEL_QUAD) return;  // other iterates
    for (const char* name : {"symmetric_projection/gauss2", "generalized_alpha/index2", "multistep/bliedf3"}) {
        Trip trip(parallelogram(), "SO3xR3", method(name));
        const Status status = trip.run(pi() / 2, 17);
        INFO(name << ": " << kreisel::name(status));
        CHECK(status != Status::ok);
        CHECK_THAT(trip.system->reason(status), Catch::Contains("rank") && Catch::Contains("joint"));
    }
}

}  // namespace implicit_lost_rank
