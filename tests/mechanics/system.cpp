// SPDX-License-Identifier: BSD-3-Clause
//
// The system interface against its own definitions: structured solves against a dense KKT matrix built from M, C, Q,
// xi; C and xi against differences; the formulations against each other.
#include "mechanics/system.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "tests/mechanics/models.hpp"

using namespace kreisel;
using namespace models;

namespace {

/// One system at one state, with everything the interface says of it as dense matrices.
struct Dense {
    Dense(System& s, const Real& t, const std::vector<Real>& y)
        : n(s.velocities()), m(s.constraints()), M(MatX::Zero(n, n)), C(m, n), Q(n), xi(m) {
        const Real* v = y.data() + s.group().size();
        const int block = s.mass_block();
        std::vector<Real> blocks(static_cast<std::size_t>(n * block));
        s.mass(y.data(), blocks.data());
        for (int i = 0; i < n / block; ++i)
            M.block(i * block, i * block, block, block) =
                Eigen::Map<MatX>(&blocks[static_cast<std::size_t>(i * block * block)], block, block);
        VecX gyroscopic(n);
        s.applied_force(t, y.data(), v, Q.data());
        s.gyroscopic_force(y.data(), v, gyroscopic.data());
        Q += gyroscopic;
        s.jacobian(t, y.data(), C.data());
        s.acceleration_bias(t, y.data(), v, xi.data());
    }
    /// (v', lambda) of [M C^T; C 0] [v'; lambda] = [f; c].
    VecX solve(const VecX& f, const VecX& c) const {
        MatX K = MatX::Zero(n + m, n + m);
        K << M, C.transpose(), C, MatX::Zero(m, m);
        VecX rhs(n + m);
        rhs << f, c;
        return K.fullPivLu().solve(rhs);
    }
    int n, m;
    MatX M, C;
    VecX Q, xi;
};

const Real tolerance = 4000 * epsilon;

template <class F>
void for_each_system(F f) {
    for (const Named& named : all())
        for (const std::string& name : applicable(named.model)) {
            INFO(named.name << " as " << name);
            auto system = make_system(named.model, name);
            const std::vector<Real> y = initial_state(*system, named.model);
            f(*system, y);
        }
}

/// y moved along the flow direction z by e.
std::vector<Real> moved(const System& system, const std::vector<Real>& y, const std::vector<Real>& z, const Real& e) {
    std::vector<Real> u = z, out(y.size());
    for (Real& x : u) x *= e;
    system.state_group().append_exp(y.data(), u.data(), out.data());
    return out;
}

#if KREISEL_QUAD
const Real e = Real(1) / 1000000;
#else
const Real e = Real(1) / 4096;
#endif
const Real difference_tolerance = 100 * e * e;

}  // namespace

TEST_CASE("accelerations and multipliers equal a dense solve of the KKT system", "[mechanics]") {
    for_each_system([](System& s, const std::vector<Real>& y) {
        const Real t = Real(3) / 10;
        const Dense dense(s, t, y);
        VecX dv(dense.n), lambda(dense.m);
        const Real* v = y.data() + s.group().size();
        REQUIRE(s.accelerations(t, y.data(), v, dv.data(), dense.m > 0 ? lambda.data() : nullptr) == Status::ok);
        const VecX expected = dense.solve(dense.Q, dense.xi);
        CHECK((dv - expected.head(dense.n)).norm() <= tolerance * max(Real(1), Real(expected.norm())));
        CHECK((lambda - expected.tail(dense.m)).norm() <= tolerance * max(Real(1), Real(expected.norm())));
    });
}

TEST_CASE("solve_kkt equals a dense solve for any right-hand side", "[mechanics]") {
    for_each_system([](System& s, const std::vector<Real>& y) {
        const Dense dense(s, 0, y);
        VecX f(dense.n), c(dense.m), a(dense.n), lambda(dense.m);
        for (int i = 0; i < dense.n; ++i) f[i] = sin(Real(i + 1));
        for (int i = 0; i < dense.m; ++i) c[i] = cos(Real(3 * i + 1));
        REQUIRE(s.solve_kkt(0, y.data(), f.data(), c.data(), a.data(), lambda.data()) == Status::ok);
        const VecX expected = dense.solve(f, c);
        CHECK((a - expected.head(dense.n)).norm() <= tolerance * expected.norm());
        CHECK((lambda - expected.tail(dense.m)).norm() <= tolerance * expected.norm());
    });
}

TEST_CASE("M is symmetric and positive definite", "[mechanics]") {
    for_each_system([](System& s, const std::vector<Real>& y) {
        const Dense dense(s, 0, y);
        CHECK(dense.M == dense.M.transpose());
        CHECK(dense.M.ldlt().isPositive());
        CHECK(dense.M.determinant() > 0);
    });
}

TEST_CASE("C is the derivative of Phi along q exp(e u)", "[mechanics]") {
    for_each_system([](System& s, const std::vector<Real>& y) {
        const Dense dense(s, 0, y);
        for (int i = 0; i < dense.n; ++i) {
            std::vector<Real> u(static_cast<std::size_t>(2 * dense.n), Real(0));
            u[static_cast<std::size_t>(i)] = 1;
            VecX plus(dense.m), minus(dense.m);
            s.position_residual(0, moved(s, y, u, e).data(), plus.data());
            s.position_residual(0, moved(s, y, u, -e).data(), minus.data());
            CHECK(((plus - minus) / (2 * e) - dense.C.col(i)).norm() <= difference_tolerance);
        }
    });
}

TEST_CASE("C v + b is the velocity residual, and its derivative along the flow vanishes", "[mechanics]") {
    for_each_system([](System& s, const std::vector<Real>& y) {
        const Dense dense(s, 0, y);
        const Real* v = y.data() + s.group().size();
        VecX direct(dense.m), residual(dense.m);
        s.velocity_bias(0, y.data(), direct.data());
        direct += dense.C * Eigen::Map<const VecX>(v, dense.n);
        s.velocity_residual(0, y.data(), v, residual.data());
        CHECK((direct - residual).norm() <= tolerance);

        // d/dt (C v + b) = C v' - xi = 0 for v' from the index-1 system: this is what xi is.
        std::vector<Real> z(static_cast<std::size_t>(2 * dense.n));
        REQUIRE(s.vector_field(0, y.data(), z.data()) == Status::ok);
        VecX plus(dense.m), minus(dense.m);
        const auto forward = moved(s, y, z, e), backward = moved(s, y, z, -e);
        s.velocity_residual(0, forward.data(), forward.data() + s.group().size(), plus.data());
        s.velocity_residual(0, backward.data(), backward.data() + s.group().size(), minus.data());
        Real speed = 1;
        for (const Real& x : z) speed = max(speed, Real(abs(x)));
        CHECK((plus - minus).norm() / (2 * e) <= difference_tolerance * speed * speed * speed);
    });
}

TEST_CASE("first integrals are constant along the exact field", "[mechanics]") {
    for_each_system([](System& s, const std::vector<Real>& y) {
        std::vector<Real> z(static_cast<std::size_t>(s.state_group().dim()));
        REQUIRE(s.vector_field(0, y.data(), z.data()) == Status::ok);
        const auto value = [&](const FirstIntegral& integral, const std::vector<Real>& state) {
            std::vector<BodyState> bodies(static_cast<std::size_t>(s.bodies()));
            s.read(state.data(), bodies.data());
            return integral.value(bodies);
        };
        Real speed = 1;
        for (const Real& x : z) speed = max(speed, Real(abs(x)));
        for (const FirstIntegral& integral : s.integrals()) {
            INFO(integral.name);
            CHECK_FALSE(integral.reason.empty());
            const Real slope = (value(integral, moved(s, y, z, e)) - value(integral, moved(s, y, z, -e))) / (2 * e);
            CHECK(abs(slope) <= difference_tolerance * speed * speed * speed * 10);
        }
    });
}

TEST_CASE("all formulations give the same accelerations of the bodies", "[mechanics]") {
    for (const Named& named : all()) {
        INFO(named.name);
        std::vector<VecX> rates;
        for (const std::string& name : applicable(named.model)) {
            auto s = make_system(named.model, name);
            const auto y = initial_state(*s, named.model);
            std::vector<Real> z(static_cast<std::size_t>(s->state_group().dim()));
            REQUIRE(s->vector_field(Real(1) / 5, y.data(), z.data()) == Status::ok);
            // omega' is the last three entries of each body in every formulation.
            VecX rate(3 * s->bodies());
            const int stride = s->velocities() / s->bodies();
            for (int i = 0; i < s->bodies(); ++i)
                rate.segment<3>(3 * i) = vec3(&z[static_cast<std::size_t>(s->velocities() + (i + 1) * stride - 3)]);
            rates.push_back(rate);
        }
        for (const VecX& rate : rates) CHECK((rate - rates[0]).norm() <= tolerance * max(Real(1), Real(rates[0].norm())));
    }
}

TEST_CASE("states survive read and write", "[mechanics]") {
    for_each_system([](System& s, const std::vector<Real>& y) {
        std::vector<BodyState> bodies(static_cast<std::size_t>(s.bodies()));
        s.read(y.data(), bodies.data());
        std::vector<Real> back(y.size());
        s.write(bodies.data(), back.data());
        Real worst = 0;
        for (std::size_t i = 0; i < y.size(); ++i) worst = max(worst, Real(abs(y[i] - back[i])));
        CHECK(worst <= 100 * epsilon);
    });
}

TEST_CASE("scaling masses and inertias leaves the motion and scales the multipliers", "[mechanics]") {
    for (Named named : all()) {
        INFO(named.name);
        const auto rates = [&](VecX& lambda) {
            auto s = make_system(named.model, "SE3");
            const auto y = initial_state(*s, named.model);
            VecX dv(s->velocities());
            lambda.resize(s->constraints());
            REQUIRE(s->accelerations(0, y.data(), y.data() + s->group().size(), dv.data(),
                                     lambda.size() > 0 ? lambda.data() : nullptr) == Status::ok);
            return dv;
        };
        VecX lambda, scaled_lambda;
        const VecX dv = rates(lambda);
        for (Body& body : named.model.bodies) body.mass *= 8, body.J *= 8;
        for (Load& load : named.model.loads) load.force *= 8, load.torque *= 8;
        const VecX scaled = rates(scaled_lambda);
        CHECK((scaled - dv).norm() <= tolerance * max(Real(1), Real(dv.norm())));
        CHECK((scaled_lambda - 8 * lambda).norm() <= tolerance * max(Real(1), Real(scaled_lambda.norm())));
    }
}

TEST_CASE("NaN and infinity in the state never answer ok", "[mechanics]") {
    for_each_system([](System& s, const std::vector<Real>& y) {
        const Real bad[] = {std::numeric_limits<Real>::quiet_NaN(), std::numeric_limits<Real>::infinity()};
        std::vector<Real> z(static_cast<std::size_t>(s.state_group().dim()));
        for (const Real& value : bad)
            for (int i = 3; i < s.state_group().size(); ++i) {
                std::vector<Real> broken = y;
                broken[static_cast<std::size_t>(i)] = value;
                const bool is_position = s.velocities() == 6 * s.bodies() && i < s.group().size() && i % 12 < 3;
                const bool is_velocity = i >= s.group().size() && s.velocities() == 6 * s.bodies() &&
                                         (i - s.group().size()) % 6 < 3;
                // Positions and, in SO3xR3, linear velocities do not enter the accelerations.
                if (is_position || is_velocity) continue;
                CHECK(s.vector_field(0, broken.data(), z.data()) != Status::ok);
            }
    });
}
