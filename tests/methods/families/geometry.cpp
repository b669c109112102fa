// SPDX-License-Identifier: BSD-3-Clause
//
// What variational and energy-momentum methods preserve, and the orders of those that take free bodies only.
#include <cmath>

#include "mechanics/free_body/free_rotation.hpp"
#include "tests/methods/stepping.hpp"

using namespace kreisel;
using namespace models;
using namespace stepping;

namespace {

/// Largest change of a first integral over steps of h, relative to the size of its terms.
Real change_over(const char* name, const Model& model, const std::string& formulation, const std::string& integral,
                 const Real& h, long steps) {
    Trip trip(model, formulation, method(name));
    const auto found = std::find_if(trip.system->integrals().begin(), trip.system->integrals().end(),
                                    [&](const FirstIntegral& one) { return one.name == integral; });
    REQUIRE(found != trip.system->integrals().end());
    const Real before = found->value({trip.bodies()});
    Real most = 0;
    for (long i = 0; i < steps; ++i) {
        REQUIRE(trip.integrator->step(h * Real(i), h, trip.y.data()) == Status::ok);
        const std::vector<BodyState> bodies = trip.bodies();
        most = max(most, Real(abs(found->value({bodies}) - before) / found->size({bodies})));
    }
    return most;
}

/// A free body with a full inertia that turns about no axis of symmetry.
Model free_body() {
    Model model = standard("free_top");
    model.bodies[0].J << 3, 1, -1, 1, 5, 1, -1, 1, 4;
    model.bodies[0].start.omega = Vec3(2, -1, 3) / 2;
    return model;
}

const long steps = KREISEL_QUAD ? 100 : 2000;
const Real h = Real(1) / 32;

}  // namespace

TEST_CASE("the discrete Moser-Veselov algorithms have their orders on the free body", "[methods][geometry]") {
    const Model model = free_body();
    const Body& body = model.bodies[0];
    const Real t_end = Real(1) / 2;
    const FreeRotation exact = free_rotation(body.J, body.start.R, body.start.omega, t_end);
    const int coarse = KREISEL_QUAD ? 16 : 2;
    for (const char* name :
         {"variational/dmv", "variational/dmv4", "variational/dmv6", "variational/dmv8", "variational/dmv10"}) {
        double errors[2];
        for (int i = 0; i < 2; ++i) {
            Trip trip(model, "SO3xR3", method(name));
            REQUIRE(trip.run(t_end, coarse << i) == Status::ok);
            errors[i] = to_double(SO3::log(exact.R.transpose() * trip.bodies()[0].R).norm());
        }
        INFO(name << ": " << errors[0] << ", " << errors[1]);
        const int order = method(name).description.order.configuration;
        CHECK(std::log2(errors[0] / errors[1]) == Approx(order).margin(KREISEL_QUAD ? 0.05 : 0.6));
    }
}

TEST_CASE("momentum and energy of a free body are kept to round-off by those that claim it", "[methods][geometry]") {
    const Model model = free_body();
    for (const Method& entry : methods())
        for (const auto& [property, integral] :
             {std::pair(Property::energy, "energy"), std::pair(Property::momentum, "angular_momentum_x")}) {
            if (!entry.description.claims(property) || !runs_on(entry, model, "SO3xR3")) continue;
            INFO(entry.description.name << ", " << integral);
            CHECK(change_over(entry.description.name.c_str(), model, "SO3xR3", integral, h, steps) < 1000 * epsilon);
        }
}

TEST_CASE("energy or momentum of a top are kept to round-off by those that claim it", "[methods][geometry]") {
    const Model model = standard("asymmetric_heavy_top");
    for (const Method& entry : methods()) {
        if (!runs_on(entry, model, "SO3")) continue;
        for (const auto& [property, integral] :
             {std::pair(Property::energy, "energy"), std::pair(Property::momentum, "angular_momentum_vertical")}) {
            if (!entry.description.claims(property, Domain::potential)) continue;
            INFO(entry.description.name << ", " << integral);
            CHECK(change_over(entry.description.name.c_str(), model, "SO3", integral, h, steps) < 4000 * epsilon);
        }
    }
}

TEST_CASE("what is not claimed is not kept", "[methods][geometry][control]") {
    const Model top = standard("asymmetric_heavy_top");
    CHECK(change_over("energy/simo_wong", top, "SO3", "energy", h, 50) > Real(1) / 1000000);
    CHECK(change_over("energy/discrete_gradient", top, "SO3", "angular_momentum_vertical", h, 50) > Real(1) / 1000000);
    CHECK(change_over("variational/rattlie", top, "SO3", "energy", h, 50) > Real(1) / 1000000);
    CHECK(change_over("energy/liemid_ea", top, "SO3", "energy", h, 50) > Real(1) / 1000000);
    CHECK(change_over("variational/lie_newmark", top, "SO3", "angular_momentum_vertical", h, 50) > Real(1) / 1000000);
}

TEST_CASE("SHAKELie goes where RATTLie goes, and with its velocity projected it is RATTLie", "[methods][geometry]") {
    for (const char* formulation : {"SO3xR3", "SE3"}) {
        INFO(formulation);
        const Model model = standard("double_pendulum");
        const Method& shakelie = method("variational/shakelie");
        Trip rattle(model, formulation, method("variational/rattlie")), shake(model, formulation, shakelie),
            projected(model, formulation, shakelie, "velocity");
        for (Trip* trip : {&rattle, &shake, &projected}) REQUIRE(trip->run(Real(1) / 4, 8) == Status::ok);
        const Distance apart = distance(rattle.bodies(), shake.bodies());
        CHECK(max(apart.position, apart.rotation) < 1000 * epsilon);
        CHECK(shake.velocity_defect() > Real(1) / 100000);
        CHECK(worst(distance(rattle.bodies(), projected.bodies())) < 10000 * epsilon);
    }
}

TEST_CASE("multipliers of SHAKELie are of order 2, those of RATTLie of order 1", "[methods][geometry]") {
    const Model model = standard("double_pendulum");
    const auto error = [&](const char* name, long n) {
        Trip trip(model, "SO3xR3", method(name));
        REQUIRE(trip.run(Real(1) / 4, n) == Status::ok);
        VecX exact(trip.system->constraints()), a(trip.system->velocities());
        Trip fine(model, "SO3xR3", method("variational/rattlie"));
        REQUIRE(fine.run(Real(1) / 4, 4096) == Status::ok);
        REQUIRE(fine.system->accelerations(Real(1) / 4, fine.y.data(), fine.system->v(fine.y.data()), a.data(),
                                           exact.data()) == Status::ok);
        return to_double((Eigen::Map<const VecX>(trip.integrator->multipliers(), exact.size()) - exact).norm());
    };
    if (KREISEL_QUAD) return;  // slow, and the same code
    const double shake = std::log2(error("variational/shakelie", 64) / error("variational/shakelie", 128));
    const double rattle = std::log2(error("variational/rattlie", 64) / error("variational/rattlie", 128));
    CHECK(shake == Approx(2).margin(0.15));
    CHECK(rattle == Approx(1).margin(0.15));
}

TEST_CASE("in coordinates of increments Lie-Verlet is RATTLie without joints", "[methods][geometry]") {
    const Model model = standard("asymmetric_heavy_top");
    for (const char* coordinates : {"exp", "cayley", "matrix"}) {
        INFO(coordinates);
        const std::string chart = std::string(coordinates) == "matrix" ? "cayley" : coordinates;
        Trip verlet(model, "SO3", method("variational/lie_verlet"), {{"coordinates", std::string(coordinates)}}),
            rattle(model, "SO3", method("variational/rattlie"), {{"coordinates", chart}});
        for (Trip* trip : {&verlet, &rattle}) REQUIRE(trip->run(Real(1) / 4, 8) == Status::ok);
        const bool equal = worst(distance(verlet.bodies(), rattle.bodies())) < 10000 * epsilon;
        CHECK(equal == (std::string(coordinates) != "matrix"));
    }
}

TEST_CASE("the energy of RATTLie stays in bounds, with joints too", "[methods][geometry]") {
    if (KREISEL_QUAD) return;  // slow, and the same code
    for (const auto& [problem, formulation] :
         {std::pair("asymmetric_heavy_top", "SE3"), std::pair("asymmetric_heavy_top", "SO3xR3")}) {
        const Real some = change_over("variational/rattlie", standard(problem), formulation, "energy", h / 8, 1000);
        CHECK(some > 1000 * epsilon);
        CHECK(change_over("variational/rattlie", standard(problem), formulation, "energy", h / 8, 4000) < 2 * some);
    }
}

TEST_CASE("the discrete Moser-Veselov algorithm declines forces, and says when a step has no solution",
          "[methods][geometry]") {
    const Method& dmv = method("variational/dmv");
    CHECK(dmv.factory.declines(*make_system(standard("heavy_top"), "SO3")) == "forces");
    CHECK(dmv.factory.declines(*make_system(standard("forced_free_body"), "SO3xR3")) == "forces");
    CHECK(dmv.factory.declines(*make_system(standard("free_top"), "SO3xR3")) == "");
    Trip trip(free_body(), "SO3xR3", dmv);
    const auto before = trip.y;
    CHECK(trip.integrator->step(0, 10, trip.y.data()) == Status::newton_failed);
    CHECK(trip.y == before);
}

TEST_CASE("a step of RATTLie that is too long for the rods fails, and leaves the state", "[methods][geometry]") {
    Trip trip(standard("double_pendulum"), "SO3xR3", method("variational/rattlie"));
    const auto before = trip.y;
    CHECK(trip.integrator->step(0, 20, trip.y.data()) != Status::ok);
    CHECK(trip.y == before);
}

TEST_CASE("Lie-Verlet and Lie-Newmark decline joints and dampers", "[methods][geometry]") {
    for (const char* name : {"variational/lie_verlet", "variational/lie_newmark"}) {
        INFO(name);
        const Method& entry = method(name);
        CHECK(entry.factory.declines(*make_system(standard("double_pendulum"), "SO3xR3")) == "joints");
        CHECK(entry.factory.declines(*make_system(standard("flyball_governor"), "SO3xR3")).find("dampers") !=
              std::string::npos);
        CHECK(entry.factory.declines(*make_system(standard("forced_heavy_top"), "SO3")) == "");
    }
}

// In Cayley coordinates no step is too long for a free body.
TEST_CASE("a step of Lie-Verlet that is too long fails, and leaves the state", "[methods][geometry]") {
    for (const char* coordinates : {"matrix", "exp"}) {
        INFO(coordinates);
        Trip trip(free_body(), "SO3xR3", method("variational/lie_verlet"), {{"coordinates", std::string(coordinates)}});
        const auto before = trip.y;
        CHECK(trip.integrator->step(0, 1000, trip.y.data()) == Status::newton_failed);
        CHECK(trip.y == before);
    }
}
