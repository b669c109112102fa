// SPDX-License-Identifier: BSD-3-Clause
//
// The closed form of the free body against integration by extrapolation on quaternions, which shares only the data
// with it, and its double version against its quad version.
#include "mechanics/free_body/free_rotation.hpp"

#include <catch2/catch.hpp>

#include "engine/reference/reference.hpp"
#include "tests/engine/closed_form_double.hpp"
#include "tests/engine/free_bodies.hpp"
#include "tests/engine/named_problem.hpp"

using namespace kreisel;
using namespace reference_tests;

namespace {

FreeRotation integrated(const FreeBody& data, const Mat3& R0, const Real& t) {
    Body body{.name = data.name};
    body.J = to_matrix(data.inertia);
    body.start.R = R0;
    body.start.omega = to_vector(data.omega);
    Model model;
    model.bodies.push_back(body);
    const ReferenceSolution solution = reference_solution(model, t);
    REQUIRE(solution.stopped.empty());
    return {solution.states[0].R, solution.states[0].omega};
}

/// Extrapolation amplifies round-off by about a thousand; both results may be wrong by their condition.
bool agree(const FreeRotation& a, const FreeRotation& b, const Real& condition) {
    return distance(a, b) < 10000 * epsilon * condition;
}

}  // namespace

TEST_CASE("the closed form of the free body agrees with integration") {
    for (const FreeBody& body : free_bodies())
        for (const Real& t : {Real(1) / 10, Real(3), Real(50)}) {
            CAPTURE(body.name, to_double(t));
            const FreeRotation closed = free_rotation(to_matrix(body.inertia), oblique, to_vector(body.omega), t);
            const FreeRotation other = integrated(body, oblique, t);
            const Real k = condition(body, oblique, t);
            CAPTURE(to_double(k), to_double(distance(closed, other)));
            CHECK(agree(closed, other, k));
            CHECK(SO3::orthogonality_defect(closed.R) < 64 * epsilon);
        }
}

TEST_CASE("control: the wrong sign of lambda is seen, in every motion that has a lambda") {
    const Real t = 3;
    for (const FreeBody& body : free_bodies()) {
        if (body.fixed_axis) continue;
        CAPTURE(body.name);
        const Mat3 J = to_matrix(body.inertia);
        const Vec3 omega = to_vector(body.omega);
        // u = -lambda t - nu: the momentum at time -t.
        const FreeRotation wrong = {free_rotation(J, oblique, omega, t).R, free_rotation(J, oblique, omega, -t).omega};
        CHECK_FALSE(agree(wrong, integrated(body, oblique, t), condition(body, oblique, t)));
    }
}

TEST_CASE("the closed form conserves energy and spatial momentum, and is a flow") {
    for (const FreeBody& body : free_bodies()) {
        CAPTURE(body.name);
        const Mat3 J = to_matrix(body.inertia);
        const Vec3 omega = to_vector(body.omega), L = oblique * J * omega;
        const Real t = 7, s = Real(-11) / 4, k = condition(body, oblique, t);
        const FreeRotation a = free_rotation(J, oblique, omega, t), b = free_rotation(J, oblique, omega, t + s);
        CHECK((a.R * J * a.omega - L).norm() < 1000 * epsilon * J.norm() * omega.norm() + epsilon * epsilon);
        CHECK(abs(a.omega.dot(J * a.omega) - omega.dot(J * omega)) <= 1000 * epsilon * omega.dot(J * omega));
        CHECK(distance(free_rotation(J, a.R, a.omega, s), b) < 1000 * epsilon * k);
    }
}

TEST_CASE("in double the closed form has the digits that its data allow") {
    const Matrix3 R0 = {0, 0, 1, 1, 0, 0, 0, 1, 0};  // exact in double
    const Real double_epsilon = std::numeric_limits<double>::epsilon();
    for (const FreeBody& body : free_bodies())
        for (const double t : {0.125, 3.0, 50.0, 1000.0}) {
            CAPTURE(body.name, t);
            const DoubleRotation rounded = free_rotation_in_double(body.inertia, R0, body.omega, t);
            const FreeRotation exact = free_rotation(to_matrix(body.inertia), to_matrix(R0), to_vector(body.omega), t);
            const Real k = condition(body, to_matrix(R0), t);
            const Real error = distance({to_matrix(rounded.R), to_vector(rounded.omega)}, exact);
            CAPTURE(to_double(k), to_double(error));
            CHECK(error < 32 * double_epsilon * k);
        }
}
