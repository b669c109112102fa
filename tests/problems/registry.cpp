// SPDX-License-Identifier: BSD-3-Clause
//
// Every registered problem in every formulation, new ones included automatically.
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "kreisel_build.hpp"
#include "mechanics/start.hpp"
#include "tests/problems/states.hpp"
#include "tests/support/bibliography.hpp"

using namespace kreisel;
using namespace checks;

namespace {

void holds(std::string (*check)(System&, const At&)) {
    states::for_each_state([&](System& system, const At& at) { CHECK(check(system, at) == ""); });
}

std::string text_of(const std::string& path) {
    std::ifstream in(path);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

/// Masses, inertias and all forces except gravity times `factor`.
Model scaled(Model model, const Real& factor) {
    for (Body& body : model.bodies) body.mass *= factor, body.J *= factor;
    for (Load& load : model.loads) load.force *= factor, load.torque *= factor;
    for (Spring& spring : model.springs) spring.stiffness *= factor, spring.damping *= factor;
    for (TorsionSpring& spring : model.torsion_springs) spring.stiffness *= factor, spring.damping *= factor;
    for (PolynomialSpring& spring : model.polynomial_springs) {
        for (Real& coefficient : spring.coefficients) coefficient *= factor;
        spring.damping *= factor;
    }
    for (Damper& damper : model.dampers) damper.damping *= factor;
    for (RotationalDamper& damper : model.rotational_dampers) damper.damping *= factor;
    for (Attraction& attraction : model.attractions) attraction.strength *= factor;
    for (Bushing& bushing : model.bushings)
        for (std::size_t i = 0; i < 2; ++i) bushing.stiffness[i] *= factor, bushing.damping[i] *= factor;
    return model;
}

}  // namespace

TEST_CASE("M is symmetric and positive definite", "[problems]") { holds(mass_is_positive); }
TEST_CASE("C is the derivative of Phi", "[problems]") { holds(jacobian_is_derivative); }
TEST_CASE("the velocity rows are C v + b with b = dPhi/dt", "[problems]") { holds(velocity_rows_are_consistent); }
TEST_CASE("C v' - xi is the derivative of C v + b", "[problems]") { holds(bias_is_derivative); }
TEST_CASE("accelerations and multipliers solve the index-1 system", "[problems]") { holds(accelerations_solve_kkt); }
TEST_CASE("the applied force is minus the gradient of the potential", "[problems]") { holds(force_is_gradient); }
TEST_CASE("forces are conservative and dissipative ones", "[problems]") { holds(force_parts_add_up); }
TEST_CASE("first integrals are constant along the exact field", "[problems]") { holds(integrals_are_constant); }

TEST_CASE("every problem starts on its joints", "[problems]") {
    for (const auto& [title, model] : states::all()) {
        INFO(title);
        CHECK_NOTHROW(check_start(model));
        for (const std::string& name : states::applicable(model)) {
            const auto s = make_system(model, name);
            const At at = states::in_coordinates(*s, states::poses(model, 0)[0]);
            VecX phi(s->position_constraints()), rate(s->constraints());
            s->position_residual(0, at.y.data(), phi.data());
            s->velocity_residual(0, at.y.data(), s->v(at.y.data()), rate.data());
            Real fastest = 1;
            for (const Body& body : model.bodies)
                fastest = max(fastest, Real(body.start.v.norm() + body.start.omega.norm()));
            CHECK(phi.norm() <= 40 * epsilon);
            CHECK(rate.norm() <= 40 * epsilon * fastest);
        }
    }
}

TEST_CASE("the bodies survive the coordinates of every formulation", "[problems]") {
    for (const auto& [title, model] : states::all()) {
        for (const std::string& name : states::applicable(model)) {
            INFO(title << " as " << name);
            const auto s = make_system(model, name);
            for (const states::Pose& pose : states::poses(model, 4)) {
                std::vector<BodyState> back(pose.bodies.size());
                s->read(states::in_coordinates(*s, pose).y.data(), back.data());
                for (std::size_t i = 0; i < back.size(); ++i) {
                    const BodyState &a = back[i], &b = pose.bodies[i];
                    CHECK((a.x - b.x).norm() + (a.R - b.R).norm() <= 100 * epsilon);
                    CHECK((a.v - b.v).norm() + (a.omega - b.omega).norm() <=
                          100 * epsilon * (1 + b.v.norm() + b.omega.norm()));
                }
            }
        }
    }
}

TEST_CASE("all formulations agree on accelerations and multipliers", "[problems]") {
    for (const auto& [title, model] : states::all()) {
        for (const states::Pose& pose : states::poses(model, 4)) {
            const auto at = [&](const std::string& name) {
                const auto s = make_system(model, name);
                return dynamics(*s, states::in_coordinates(*s, pose));
            };
            const Dynamics mixed = at("SO3xR3");
            for (const std::string& name : states::applicable(model)) {
                INFO(title << " as " << name << " at t = " << to_double(pose.t));
                Dynamics other = at(name);
                if (other.multipliers.size() == 0) other.multipliers = mixed.multipliers;  // SO3 has none
                CHECK(same_dynamics(mixed, other) == "");
            }
        }
    }
}

TEST_CASE("scaling masses, inertias and loads keeps the accelerations and scales the multipliers", "[problems]") {
    const Real factor = 16;  // its square root too is exact
    for (const auto& [title, model] : states::all()) {
        const Model heavy = scaled(model, factor);
        for (const states::Pose& pose : states::poses(model, 4))
            for (const std::string& name : states::applicable(model)) {
                INFO(title << " as " << name);
                const auto light_system = make_system(model, name), heavy_system = make_system(heavy, name);
                Dynamics light = dynamics(*light_system, states::in_coordinates(*light_system, pose));
                light.multipliers *= factor;
                CHECK(same_dynamics(light, dynamics(*heavy_system, states::in_coordinates(*heavy_system, pose))) == "");
            }
    }
}

TEST_CASE("every problem says what its numbers are and where they come from", "[problems]") {
    for (const Problem& problem : problems()) {
        const ProblemDescription& about = problem.description;
        INFO(about.name);
        CHECK_FALSE(about.summary.empty());
        for (const ParameterDescription& parameter : about.parameters) {
            INFO(parameter.name);
            CHECK_FALSE(parameter.summary.empty());
            // Entries of lists carry their own units, flags have none.
            const std::set<ParameterKind> without = {ParameterKind::bodies, ParameterKind::joints,
                                                     ParameterKind::forces, ParameterKind::flag};
            CHECK(parameter.unit.empty() == without.contains(parameter.kind));
        }
        check_cites(about.name, about.cites);
        const std::string file = text_of(std::string(build::source_dir) + "/problems/" + about.name + ".cpp");
        REQUIRE_FALSE(file.empty());
        static const std::regex our_own("data\\s+(// )?are\\s+(// )?our\\s+(// )?own");  // over the end of a line too
        const bool own_data = std::regex_search(file, our_own);
        CHECK(own_data == about.cites.empty());
    }
}
