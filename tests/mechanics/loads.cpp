// SPDX-License-Identifier: BSD-3-Clause
//
// Loads against the balances of momentum in space axes, which do not depend on the formulation, and where loads break a
// law of conservation or exclude a formulation.
#include "mechanics/integrals.hpp"
#include "tests/mechanics/models/models.hpp"

using namespace kreisel;
using namespace models;

namespace {

const Vec3 space_force(3, -1, 2), body_force(-1, 2, 1), space_torque(1, 2, -1), body_torque(2, -1, 3);

Model free_body() {
    Model model;
    model.bodies.push_back(asymmetric_body(1));
    return model;
}

}  // namespace

TEST_CASE("loads change linear and angular momentum by force and torque", "[mechanics]") {
    const Model model = loaded(free_body());
    const Body& body = model.bodies[0];
    const Real t = Real(3) / 5;
    const Real in_space = 1 + sin(3 * t) / 2, in_body = 1 + sin(2 * t) / 4;
    for (const std::string& name : applicable(model)) {
        INFO(name);
        const auto s = make_system(model, name);
        const auto y = initial_state(*s, model);
        const Real* v = s->v(y.data());
        VecX dv(6);
        REQUIRE(s->accelerations(t, y.data(), v, dv.data(), nullptr) == Status::ok);
        const Mat3& R = body.start.R;
        const Vec3 w = body.start.omega, dw = dv.tail<3>();
        // On SE3 the linear velocity is R^T x', so x'' = R (V' + omega x V).
        const Vec3 V = vec3(v), A = dv.head<3>();
        const Vec3 x2 = name == "SE3" ? Vec3(R * (A + w.cross(V))) : A;
        const Vec3 force = in_space * space_force + in_body * (R * body_force);
        const Vec3 torque = in_space * space_torque + in_body * (R * body_torque);
        CHECK((body.mass * x2 - force).norm() <= 100 * epsilon);
        CHECK((R * (body.J * dw + w.cross(body.J * w)) - torque).norm() <= 100 * epsilon);
    }
}

TEST_CASE("a loaded model declares no first integral and no potential", "[mechanics]") {
    for (const char* name : {"heavy_top", "free_top"}) {
        CHECK_FALSE(first_integrals(standard(name)).empty());
        const Model model = loaded(standard(name));
        CHECK(first_integrals(model).empty());
        for (const std::string& formulation : applicable(model))
            CHECK_FALSE(make_system(model, formulation)->has_potential());
    }
}

TEST_CASE("a free body keeps its place under a torque, and loses it under a force", "[mechanics]") {
    Model model = free_body();
    model.loads.push_back({.torque = Vec3(1, 0, 0)});
    CHECK(formulation("SO3").why_not(model).empty());
    model.loads.push_back({.force = Vec3(1, 0, 0)});
    CHECK_FALSE(formulation("SO3").why_not(model).empty());
}
