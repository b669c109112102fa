// SPDX-License-Identifier: BSD-3-Clause
//
// What projections and stabilisations do to runs: orders, the decay of defects, which coordinates move, which steps.
#include <set>

#include "tests/methods/control/controlled_trip.hpp"

using namespace kreisel;
using namespace models;
using namespace stepping;

namespace {

struct Stabilising {
    std::string name;
    OptionValues options = {};
};

/// Mean order over five halvings of the step, from distances between runs with N and 2N steps. Over one halving the
/// error of a coordinate partitioning falls by between 2^2 and 2^4.5 at order 3 or 4: where along a run the partition
/// changes depends on the step.
Real seen_order(const std::string& method_name, const Stabilising& how, const std::string& formulation) {
    const Method& entry = method(method_name);
    const auto end = [&](long steps) {
        Trip trip(standard("double_pendulum"), formulation, entry, default_options(entry.description.options), how.name,
                  how.options);
        REQUIRE(trip.run(1, steps) == Status::ok);
        return VecX(Eigen::Map<const VecX>(trip.y.data(), static_cast<Eigen::Index>(trip.y.size())));
    };
    return log2(Real((end(128) - end(256)).norm() / (end(4096) - end(8192)).norm())) / 5;
}

}  // namespace

TEST_CASE("orders stay under every projection and under feedback at rates of its own", "[methods]") {
    if (KREISEL_QUAD) return;  // slow, and the same code
    for (const Stabilising& how : {Stabilising{"none"},
                                   {"position_velocity", {{"every", 4L}}},
                                   {"position_velocity", {{"iterations", "one"}}},
                                   {"position_velocity", {{"weight", "identity"}}},
                                   {"terze", {{"iterations", "one"}}},
                                   {"coordinate_partitioning"},
                                   {"coordinate_partitioning", {{"every", 4L}}},
                                   {"baumgarte"},
                                   {"baumgarte", {{"alpha", 2.0}, {"beta", 9.0}}}})
        for (const auto& [name, order] : {std::pair<std::string, int>("rkmk/kutta3", 3), {"rkmk/rk4", 4}}) {
            INFO(how.name << ", " << name);
            CHECK(to_double(seen_order(name, how, "SO3xR3")) > order - 0.3);
        }
}

TEST_CASE("feedback at rates per step costs methods their order", "[methods]") {
    if (KREISEL_QUAD) return;
    CHECK(to_double(seen_order("rkmk/rk4", {"baumgarte_step"}, "SO3xR3")) < 3);
}

TEST_CASE("off the constraints, feedback lets defects decay as it says", "[methods]") {
    const Real alpha = 6, t = 1;
    for (const std::string formulation : {"SO3xR3", "SE3"}) {
        const Method& rk4 = method("rkmk/rk4");
        Trip trip(standard("double_pendulum"), formulation, rk4, default_options(rk4.description.options), "baumgarte",
                  {{"alpha", 6.0}, {"beta", 6.0}});
        Real* v = trip.system->v(trip.y.data());
        for (int i = 0; i < trip.system->velocities(); ++i) v[i] += sin(Real(i + 1)) / 100;
        VecX rate(trip.system->constraints()), rows(rate);
        trip.system->velocity_residual(0, trip.y.data(), v, rate.data());
        REQUIRE(trip.run(t, KREISEL_QUAD ? 100 : 1000) == Status::ok);
        // Critically damped from Phi = 0: Phi(t) = t e^(-alpha t) Phi'(0).
        trip.system->position_residual(t, trip.y.data(), rows.data());
        CHECK((rows - t * exp(-alpha * t) * rate).norm() <= rate.norm() / (KREISEL_QUAD ? 1000 : 10000000));
        trip.system->velocity_residual(t, trip.y.data(), trip.system->v(trip.y.data()), rows.data());
        CHECK((rows - (1 - alpha * t) * exp(-alpha * t) * rate).norm() <=
              rate.norm() / (KREISEL_QUAD ? 1000 : 10000000));
    }
}

TEST_CASE("a partition moves as many coordinates as there are rows, and keeps them", "[methods]") {
    Trip trip(standard("double_pendulum"), "SE3", method("rkmk/rk4"), "coordinate_partitioning");
    const auto n = static_cast<std::size_t>(trip.system->velocities());
    std::set<std::size_t> first;
    for (int run = 0; run < 3; ++run) {
        Real* v = trip.system->v(trip.y.data());
        for (std::size_t i = 0; i < n; ++i) v[i] += sin(Real(static_cast<int>(i) + run)) / 10;
        const std::vector<Real> before(v, v + n);
        REQUIRE(trip.project->project(0, trip.y.data()) == Status::ok);
        std::set<std::size_t> moved;
        for (std::size_t i = 0; i < n; ++i)
            if (v[i] != before[i]) moved.insert(i);
        CHECK(moved.size() == static_cast<std::size_t>(trip.system->constraints()));
        if (run == 0) first = moved;
        CHECK(moved == first);
    }
}

TEST_CASE("a partition is not chosen by round-off", "[methods]") {
    if (KREISEL_QUAD) return;  // slow, and the same code
    const auto end = [](const Real& factor) {
        Trip trip(standard("heavy_top"), "SO3xR3", method("rkmk/rk4"), "coordinate_partitioning");
        for (Real* v = trip.system->v(trip.y.data()); v != trip.y.data() + trip.y.size(); ++v) *v *= factor;
        REQUIRE(trip.run(1, 2000) == Status::ok);
        return VecX(Eigen::Map<const VecX>(trip.y.data(), static_cast<Eigen::Index>(trip.y.size())));
    };
    const VecX undisturbed = end(1);
    for (int units = 1; units < 12; ++units) {
        INFO(units << " units of round-off");
        CHECK(to_double((end(1 + units * epsilon) - undisturbed).norm() / undisturbed.norm()) < 1e-11);
    }
}
