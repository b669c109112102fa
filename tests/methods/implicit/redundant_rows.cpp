// SPDX-License-Identifier: BSD-3-Clause
//
// Implicit methods on mechanisms with redundant rows, in every unit and place.
#include <cmath>

#include "tests/methods/implicit/for_each.hpp"

namespace implicit_redundant_rows {

using namespace kreisel;
using namespace models;
using namespace stepping;
using namespace linkages;

namespace {

/// Of order 4, with steps much smaller than those of the test.
std::vector<BodyState> precise(const Model& model, const std::string& formulation, const Real& t_end, long steps) {
    Trip trip(model, formulation, method("rkmk/rk4"), "position_velocity");
    REQUIRE(trip.run(t_end, steps) == Status::ok);
    return trip.bodies();
}

/// Distance of the method's own multipliers from those of the index-1 form at the end.
double multiplier_error(const Trip& trip, const Real& t) {
    System& s = *trip.system;
    VecX dv(s.velocities()), exact(s.constraints());
    const Real* v = s.v(trip.y.data());
    REQUIRE(s.accelerations(t, trip.y.data(), v, dv.data(), exact.data()) == Status::ok);
    REQUIRE(trip.integrator->multipliers() != nullptr);
    return to_double((Eigen::Map<const VecX>(trip.integrator->multipliers(), exact.size()) - exact).norm());
}

}  // namespace

TEST_CASE("implicit methods run on redundant rows at their order", "[methods]") {
    const Real t_end = Real(1) / (KREISEL_QUAD ? 8 : 4);
    const long few = KREISEL_QUAD ? 32 : 64;
    for (const Named& named : redundant_linkages()) {
        REQUIRE_FALSE(has_independent_rows(named.model));
        const bool all_formulations = named.name == "planar four-bar" && !KREISEL_QUAD;
        if (KREISEL_QUAD && named.name != "planar four-bar") continue;  // slow, and the same code
        for (const std::string& formulation : applicable(named.model)) {
            if (formulation != "SO3xR3" && !all_formulations) continue;
            INFO(named.name << " as " << formulation);
            const auto exact = precise(named.model, formulation, t_end, 16 * few);
            for_each_implicit([&](const Method& entry) {
                if (KREISEL_QUAD && entry.description.order.configuration < 3) return;  // errors far from round-off
                double errors[2], multipliers[2];
                for (int i = 0; i < 2; ++i) {
                    Trip trip(named.model, formulation, entry);
                    REQUIRE(trip.run(t_end, few << i) == Status::ok);
                    errors[i] = to_double(worst(distance(trip.bodies(), exact)));
                    if (entry.description.reports_multipliers) multipliers[i] = multiplier_error(trip, t_end);
                    if (!entry.description.meets_constraints()) continue;
                    CHECK(trip.position_defect(t_end) <= 1000 * epsilon);
                    CHECK(trip.velocity_defect(t_end) <= 10000 * epsilon);
                }
                CHECK(errors[1] < 1e-2);
                const Order& order = entry.description.order;
                // To 1e-12 the solution of order 4 is known; velocities that follow from positions alone have round-off
                // over h, their multipliers over h^2, and the iteration leaves some units of it.
                const bool quotients = entry.description.meets_positions && !entry.description.meets_velocities;
                if (errors[1] > (quotients ? 1e-10 : 1e-12))
                    CHECK(std::log2(errors[0] / errors[1]) >= order.configuration - 0.15);
                if (entry.description.reports_multipliers && multipliers[1] > (quotients ? 1e-7 : 1e-12))
                    CHECK(std::log2(multipliers[0] / multipliers[1]) >= order.multipliers - 0.2);
            });
        }
    }
}

TEST_CASE("a linkage moves the same in every unit", "[methods]") {
    const Model one = planar_four_bar();
    const int steps = KREISEL_QUAD ? 5 : 100;
    for_each_implicit([&](const Method& entry) {
        Trip reference(one, "SO3xR3", entry);
        REQUIRE(reference.run(Real(steps) / 200, steps) == Status::ok);
        for (const int length : {-20, -7, 10, 20})
            for (const int mass : {-20, 0, 20}) {
                if (KREISEL_QUAD && (abs(length) != 20 || mass != -length)) continue;  // slow, and the same code
                INFO("lengths times 2^" << length << ", masses times 2^" << mass);
                const Real L = pow(Real(2), length), m = pow(Real(2), mass);
                Trip trip(in_units(one, L, m), "SO3xR3", entry);
                REQUIRE(trip.run(Real(steps) / 200, steps) == Status::ok);
                CHECK(distance_in_units(trip.bodies(), reference.bodies(), L) <= 1000000 * epsilon);
            }
    });
}

TEST_CASE("a linkage moves the same in every place", "[methods]") {
    const Model one = planar_four_bar();
    const int steps = KREISEL_QUAD ? 5 : 50;
    for_each_implicit([&](const Method& entry) {
        Trip reference(one, "SO3xR3", entry);
        REQUIRE(reference.run(Real(steps) / 200, steps) == Status::ok);
        for (const Real& far : {Real(1024), Real(1048576)}) {
            INFO("moved by " << far);
            const Vec3 origin = far * Vec3(1, -2, 1);
            Trip trip(in_units(one, 1, 1, origin), "SO3xR3", entry);
            REQUIRE(trip.run(Real(steps) / 200, steps) == Status::ok);
            // Positions have the round-off of their size, velocities that over h, and where they follow from positions
            // alone there is no equation that would damp it.
            const bool quotients = entry.description.meets_positions && !entry.description.meets_velocities;
            CHECK(to_double(distance_in_units(trip.bodies(), reference.bodies(), 1, origin) / (epsilon * far)) <=
                  (quotients ? 1000000 : 100000));
        }
    });
}

}  // namespace implicit_redundant_rows
