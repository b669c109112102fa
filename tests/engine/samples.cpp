// SPDX-License-Identifier: BSD-3-Clause
//
// References at the samples of a run, each with an error of its own, confirmed by the second route.
#include <catch2/catch.hpp>
#include <limits>

#include "engine/reported_reference.hpp"
#include "mechanics/joints/joint_rows.hpp"
#include "tests/engine/named_problem.hpp"
#include "tests/engine/two_routes.hpp"

using namespace kreisel;
using namespace reference_tests;

namespace {

bool same_states(const std::vector<BodyState>& a, const std::vector<BodyState>& b) {
    const Distance d = distance(a, b);
    return d.position == 0 && d.velocity == 0 && d.omega == 0 && a[0].R == b[0].R;
}

Real largest_part(const Distance& d) { return max(max(d.position, d.rotation), max(d.velocity, d.omega)); }

}  // namespace

TEST_CASE("samples leave a reference as it is, and the last of them is its end") {
    const Model model = standard_model("double_pendulum");
    const ReferenceSolution plain = confirmed_reference(model, Real(1) / 2);
    const ReferenceSolution sampled = confirmed_reference(model, Real(1) / 2, {}, 5);
    CHECK(plain.samples.empty());
    REQUIRE(sampled.samples.size() == 5);
    CHECK(same_states(plain.states, sampled.states));
    CHECK(plain.multipliers == sampled.multipliers);
    CHECK(plain.position_error == sampled.position_error);
    CHECK(plain.omega_error == sampled.omega_error);
    CHECK(plain.multiplier_error.force == sampled.multiplier_error.force);
    CHECK(plain.horizon == sampled.horizon);
    CHECK(plain.route == sampled.route);
    CHECK(sampled.samples.back().point.t == Real(1) / 2);
    CHECK(same_states(sampled.samples.back().point.states, sampled.states));
    CHECK(sampled.samples.back().multipliers == sampled.multipliers);
}

TEST_CASE("a sample is the reference of its time, within the errors of both") {
    for (const char* name : {"heavy_top", "forced_heavy_top", "double_pendulum", "slider_crank"}) {
        const Model model = standard_model(name);
        const Real t_end = Real(1) / 8;
        const ReferenceSolution sampled = confirmed_reference(model, t_end, {}, 3);
        REQUIRE(sampled.samples.size() == 3);
        for (const SampledPoint& sample : sampled.samples) {
            const ReferenceSolution direct = confirmed_reference(model, sample.point.t);
            const Distance apart = distance(direct.states, sample.point.states);
            const MultiplierDistance lambda =
                multiplier_distance(constraint_rows(model), direct.multipliers, sample.multipliers);
            INFO(name << " at " << to_double(sample.point.t));
            CHECK(apart.position <= 2 * (sample.error.position + direct.position_error));
            CHECK(apart.rotation <= 2 * (sample.error.rotation + direct.rotation_error));
            CHECK(apart.velocity <= 2 * (sample.error.velocity + direct.velocity_error));
            CHECK(apart.omega <= 2 * (sample.error.omega + direct.omega_error));
            CHECK(lambda.force <= 2 * (sample.multiplier_error.force + direct.multiplier_error.force));
            CHECK(largest_part(sample.error) < Real("1e-20"));
            CHECK(largest_part(sample.error) > 0);
        }
    }
}

TEST_CASE("past the horizon the errors of samples do not fall, and multipliers are unknown") {
    Body body;  // on its separatrix, held at its mass centre
    body.J = Vec3(1, 2, Real(9) / 4).asDiagonal();
    body.start.omega = Vec3(3, 2, 4) / 4;
    Model model;
    model.bodies.push_back(body);
    model.join(ground, 0, Vec3::Zero());
    const ReferenceSolution far = confirmed_reference(model, Real(200), {}, 20);
    REQUIRE(far.horizon < Real(180));
    Real before = 0;
    int past = 0;
    for (const SampledPoint& sample : far.samples) {
        const bool beyond = sample.point.t > far.horizon;
        CHECK(isfinite(sample.multiplier_error.force) != beyond);
        if (!beyond) continue;
        CHECK(sample.error.rotation >= before);
        before = sample.error.rotation, ++past;
    }
    CHECK(past > 1);
    CHECK(before > Real(1) / 1000000000000);
}

TEST_CASE("a check of a reference finds which sample is wrong") {
    const Problem& top = problem("heavy_top");
    const ParameterValues values = demonstration_parameters(top.description);
    Reference reference = reported_reference(top, values, nullptr, 0.125, 4, {});
    REQUIRE(reference.samples.size() == 4);
    CHECK(reference.error.at("error.position.max").value >= reference.samples[1].error.at("error.position").value);
    CHECK(reference.error.contains("error.multipliers.max"));
    const auto off = [&](const ReferenceCheck& check, std::size_t i) {
        return check.samples.at(i).at("error.position").value / reference.samples[i].error.at("error.position").value;
    };
    const ReferenceCheck good = checked_reference(top, values, nullptr, reference);
    REQUIRE(good.failure.empty());
    for (std::size_t i = 0; i < 4; ++i) CHECK(off(good, i) <= 1);
    Number& x = reference.samples[2].state.bodies[0].x[0];
    x = to_number(from_number(x) + 1000 * from_number(reference.samples[2].error.at("error.position")));
    const ReferenceCheck bad = checked_reference(top, values, nullptr, reference);
    CHECK(off(bad, 1) <= 1);
    CHECK(off(bad, 2) > 100);
}

TEST_CASE("a problem with a closed form has its distance in the errors of samples") {
    const Problem& top = problem("free_top");
    REQUIRE(top.closed_form);
    const Reference reference = reported_reference(top, demonstration_parameters(top.description), nullptr, 1, 2, {});
    REQUIRE(reference.samples.size() == 2);
    for (const ReferenceSample& sample : reference.samples) {
        const auto exact =
            top.closed_form(Parameters(demonstration_parameters(top.description)), from_number(sample.state.t));
        CHECK(distance(from_report(sample.state), exact).omega <=
              2 * from_number(sample.error.at("error.omega")) + epsilon);
    }
}
