// SPDX-License-Identifier: BSD-3-Clause
//
// rkmk/rk4 on the literature's fast top: errors and drift of the index-1 form without stabilisation, and the
// effect of the projections. The reference at t = 1 was obtained by two independent programs to 22 digits. The expected
// errors are those of double precision runs, so the file is empty in quad.
#include "tests/methods/stepping.hpp"

using namespace kreisel;
using namespace models;
using namespace stepping;

#if !KREISEL_QUAD

namespace {

/// |x - x_ref| at t = 1 s for rkmk/rk4 with N steps.
Real error_at_one(const std::string& formulation, long steps, const std::string& projector = "none") {
    Trip trip(standard("heavy_top"), formulation, method("rkmk/rk4"), projector);
    REQUIRE(trip.run(1, steps) == Status::ok);
    const Vec3 exact(from_text("0.1733439640983860426"), from_text("0.6400885920705687829"),
                     from_text("-0.7484907911335813095"));
    return (trip.bodies()[0].x - exact).norm();
}

Real drift(long seconds) {
    Trip trip(standard("heavy_top"), "SO3xR3", method("rkmk/rk4"));
    REQUIRE(trip.run(Real(seconds), 1000 * seconds) == Status::ok);
    return trip.position_defect();
}

void within_five_percent(const Real& got, double expected) { CHECK(to_double(got) == Approx(expected).epsilon(0.05)); }

}  // namespace

TEST_CASE("fast top: errors of rkmk/rk4 without projection", "[methods]") {
    within_five_percent(error_at_one("SO3xR3", 1000), 1.15e-3);
    within_five_percent(error_at_one("SO3xR3", 2000), 7.4e-5);
    within_five_percent(error_at_one("SO3xR3", 8000), 2.9e-7);
    within_five_percent(error_at_one("SE3", 1000), 1.34e-4);
    within_five_percent(error_at_one("SE3", 2000), 9.3e-6);
    within_five_percent(error_at_one("SE3", 8000), 4.0e-8);
}

TEST_CASE("fast top: the position constraint drifts on SO3xR3", "[methods]") {
    within_five_percent(drift(1), 1.2e-3);
    within_five_percent(drift(2), 4.4e-3);
    within_five_percent(drift(16), 1.7e-1);
}

TEST_CASE("fast top: a joint to the ground leaves a subgroup of SE3, so nothing drifts there", "[methods]") {
    for (const long steps : {250, 1000, 4000}) {
        Trip trip(standard("heavy_top"), "SE3", method("rkmk/rk4"));
        REQUIRE(trip.run(1, steps) == Status::ok);
        // Round-off of accelerations of size 700 over one second.
        CHECK(trip.position_defect() <= 700 * 4 * epsilon);
        CHECK(trip.velocity_defect() <= 700 * 4 * epsilon);
    }
}

TEST_CASE("position_velocity and terze hold both constraints below 1e-11", "[methods]") {
    for (const char* projector : {"position_velocity", "terze"}) {
        Trip trip(standard("heavy_top"), "SO3xR3", method("rkmk/rk4"), projector);
        const Real h = Real(1) / 1000;
        Real worst_position = 0, worst_velocity = 0;
        for (int i = 0; i < 1000; ++i) {
            REQUIRE(trip.integrator->step(h * i, h, trip.y.data()) == Status::ok);
            REQUIRE(trip.project->project(h * (i + 1), trip.y.data()) == Status::ok);
            worst_position = max(worst_position, trip.position_defect());
            worst_velocity = max(worst_velocity, trip.velocity_defect());
        }
        INFO(projector);
        CHECK(to_double(worst_position) < 1e-11);
        CHECK(to_double(worst_velocity) < 1e-11);
    }
}

TEST_CASE("projections keep the order of the method", "[methods]") {
    // terze in the identity norm has a large next term: its slopes fall to 4 as 4.44, 4.29, 4.17, 4.09, 4.05 from 1,000
    // to 32,000 steps, halving the excess each time, so the asymptotic range starts there.
    for (const char* projector : {"velocity", "position", "position_velocity", "terze"}) {
        const Real coarse = error_at_one("SO3xR3", 16000, projector), fine = error_at_one("SO3xR3", 32000, projector);
        INFO(projector);
        CHECK(to_double(log2(coarse / fine)) == Approx(4).margin(0.1));
    }
}

TEST_CASE("on a pivoted body the formulations give the same rotation at equal h", "[methods]") {
    // Eliminating the multipliers from the index-1 form gives the pivot's own equation; as unknowns they are
    // discretised, and projections move what drifts.
    for (const Method& entry : methods()) {
        if (!runs_on(entry, standard("forced_heavy_top"), "SE3") || entry.description.reports_multipliers) continue;
        if (entry.description.meets_constraints()) continue;
        if (!entry.description.formulations.empty()) continue;
        std::vector<std::vector<BodyState>> ends;
        for (const char* formulation : {"SO3", "S3", "SO3xR3", "SE3"}) {
            Trip trip(standard("forced_heavy_top"), formulation, entry);
            REQUIRE(trip.run(1, 256) == Status::ok);
            ends.push_back(trip.bodies());
        }
        INFO(entry.description.name);
        for (const auto& end : ends) {
            const Distance d = distance(end, ends[0]);
            CHECK(d.rotation <= 2000 * epsilon);
            CHECK(d.omega <= 4000 * epsilon);
        }
    }
}

#endif
