// SPDX-License-Identifier: BSD-3-Clause
//
// What iterations of implicit steps take, their unknowns, and a guess that leads nowhere.
#include <utility>

#include "mechanics/forwarding_system.hpp"
#include "mechanics/space_axes.hpp"
#include "tests/methods/stepping.hpp"

namespace implicit_iterations {

using namespace kreisel;
using namespace models;
using namespace stepping;

namespace {

/// Where no stage of a method is, at the very start, accelerations are so large that what is guessed from them turns
/// bodies many times within a step.
class KickedGuess final : public ForwardingSystem {
  public:
    using ForwardingSystem::ForwardingSystem;
    Status accelerations(const Real& t, const Real* q, const Real* v, Real* dv, Real* lambda) override {
        const Status status = ForwardingSystem::accelerations(t, q, v, dv, lambda);
        if (t == 0)
            for (int i = 0; i < velocities(); ++i) dv[i] += 1048576;
        return status;
    }
};

std::vector<Real> after_steps(const Method& entry, std::unique_ptr<System> system, const Model& model) {
    std::vector<Real> y = initial_state(*system, model);
    const auto integrator = entry.bind(*system, default_options(entry.description.options));
    REQUIRE(integrator->start(0, y.data()) == Status::ok);
    const Real h = Real(1) / 64;
    for (int i = 0; i < 2; ++i) REQUIRE(integrator->step(h * i, h, y.data()) == Status::ok);
    return y;
}

}  // namespace

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

TEST_CASE("a guess outside the chart is no end of a step", "[methods]") {
    const Model model = standard("free_top");
    for (const char* name : {"rkmk/gauss2", "rkmk/gauss3", "rkmk/radau2a2", "rkmk/radau2a3",
                             "symmetric_projection/gauss2", "variational/rattlie", "variational/shakelie"}) {
        INFO(name);
        const auto y = after_steps(method(name), make_system(model, "SO3"), model),
                   kicked = after_steps(method(name), std::make_unique<KickedGuess>(make_system(model, "SO3")), model);
        for (std::size_t i = 0; i < y.size(); ++i) CHECK(abs(y[i] - kicked[i]) <= 1000 * epsilon);
    }
}

}  // namespace implicit_iterations
