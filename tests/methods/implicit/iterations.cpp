// SPDX-License-Identifier: BSD-3-Clause
//
// What iterations of implicit steps take, and their unknowns.
#include <utility>

#include "mechanics/space_axes.hpp"
#include "tests/methods/stepping.hpp"

namespace implicit_iterations {

using namespace kreisel;
using namespace models;
using namespace stepping;

TEST_CASE("velocities turn into space axes and back", "[methods]") {
    for (const Named& named : for_methods())
        for (const std::string& formulation : applicable(named.model)) {
            INFO(named.name << " as " << formulation);
            const auto system = make_system(named.model, formulation);
            const auto* axes = dynamic_cast<const SpaceAxes*>(system.get());
            REQUIRE(axes != nullptr);
            const std::vector<Real> y = initial_state(*system, named.model);
            std::vector<BodyState> bodies(named.model.bodies.size());
            system->read(y.data(), bodies.data());
            const Real* v = system->v(y.data());
            VecX turned(system->velocities()), back(turned);
            axes->to_space_axes(y.data(), v, turned.data());
            axes->from_space_axes(y.data(), turned.data(), back.data());
            CHECK((back - Eigen::Map<const VecX>(v, back.size())).norm() <= 16 * epsilon * (1 + back.norm()));
            const auto parts = turned.size() / 3, each = parts / static_cast<Eigen::Index>(bodies.size());
            for (Eigen::Index i = 0; i < parts; ++i) {
                const BodyState& body = bodies[static_cast<std::size_t>(i / each)];
                const Vec3 angular = body.R * body.omega, expected = i % each == each - 1 ? angular : body.v;
                CHECK((turned.segment<3>(3 * i) - expected).norm() <= 16 * epsilon * (1 + expected.norm()));
            }
        }
}

TEST_CASE("implicit steps of a fast top take few evaluations, in every formulation", "[methods]") {
    if (KREISEL_QUAD) return;  // twice the digits take more
    const Model top = standard("heavy_top");
    const Real h = Real(1) / 1000;
    for (const auto& [method_name, most] :
         {std::pair("rkmk/implicit_midpoint", 3), std::pair("generalized_alpha/index2", 4),
          std::pair("multistep/bliedf2", 5)})
        for (const std::string& formulation : applicable(top)) {
            if (!runs_on(method(method_name), top, formulation)) continue;
            INFO(method_name << " as " << formulation);
            Trip trip(top, formulation, method(method_name));
            REQUIRE(trip.run(h * 100, 100) == Status::ok);
            const long before = trip.system->evaluations();
            const int steps = 500;
            for (int i = 100; i < 100 + steps; ++i)
                REQUIRE(trip.integrator->step(h * i, h, trip.y.data()) == Status::ok);
            CHECK(trip.system->evaluations() - before <= most * steps);
        }
}

}  // namespace implicit_iterations
