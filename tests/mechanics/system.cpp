// SPDX-License-Identifier: BSD-3-Clause
//
// Structured solves against a dense KKT matrix built from M, C, Q and xi. That these are correct is checked for
// the same models in tests/problems.
#include "mechanics/system.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "tests/mechanics/models/models.hpp"

using namespace kreisel;
using namespace models;

namespace {

/// One system at one state, with all matrices and vectors of the interface in dense form.
struct Dense {
    Dense(System& s, const Real& t, const std::vector<Real>& y)
        : n(s.velocities()), m(s.constraints()), M(MatX::Zero(n, n)), C(m, n), Q(n), xi(m) {
        const Real* v = s.v(y.data());
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

/// A Schur complement has the square of the condition of M^{-1/2} C^T.
Real tolerance(const System& s) {
    const Real condition = s.constraint_rank().condition.value_or(1);
    return (4000 + 10 * condition * condition) * epsilon;
}

template <class F>
void with_independent_rows(F f) {
    for (const Named& named : all()) {
        if (!has_independent_rows(named.model)) continue;  // tests/mechanics/redundant.cpp
        for (const std::string& name : applicable(named.model)) {
            INFO(named.name << " as " << name);
            auto system = make_system(named.model, name);
            const std::vector<Real> y = initial_state(*system, named.model);
            f(*system, y);
        }
    }
}

}  // namespace

TEST_CASE("accelerations and multipliers equal a dense solve of the KKT system", "[mechanics]") {
    with_independent_rows([](System& s, const std::vector<Real>& y) {
        const Real t = Real(3) / 10;
        const Dense dense(s, t, y);
        VecX dv(dense.n), lambda(dense.m);
        const Real* v = s.v(y.data());
        REQUIRE(s.accelerations(t, y.data(), v, dv.data(), dense.m > 0 ? lambda.data() : nullptr) == Status::ok);
        const VecX expected = dense.solve(dense.Q, dense.xi);
        CHECK((dv - expected.head(dense.n)).norm() <= tolerance(s) * max(Real(1), Real(expected.norm())));
        CHECK((lambda - expected.tail(dense.m)).norm() <= tolerance(s) * max(Real(1), Real(expected.norm())));
    });
}

TEST_CASE("solve_kkt equals a dense solve for any right-hand side", "[mechanics]") {
    with_independent_rows([](System& s, const std::vector<Real>& y) {
        const Dense dense(s, 0, y);
        VecX f(dense.n), c(dense.m), a(dense.n), lambda(dense.m);
        for (int i = 0; i < dense.n; ++i) f[i] = sin(Real(i + 1));
        for (int i = 0; i < dense.m; ++i) c[i] = cos(Real(3 * i + 1));
        REQUIRE(s.solve_kkt(0, y.data(), f.data(), c.data(), a.data(), lambda.data()) == Status::ok);
        const VecX expected = dense.solve(f, c);
        CHECK((a - expected.head(dense.n)).norm() <= tolerance(s) * expected.norm());
        CHECK((lambda - expected.tail(dense.m)).norm() <= tolerance(s) * expected.norm());
    });
}

TEST_CASE("NaN and infinity in the state never return ok", "[mechanics]") {
    with_independent_rows([](System& s, const std::vector<Real>& y) {
        const Real bad[] = {std::numeric_limits<Real>::quiet_NaN(), std::numeric_limits<Real>::infinity()};
        std::vector<Real> z(static_cast<std::size_t>(s.state_group().dim()));
        for (const Real& value : bad)
            for (int i = 3; i < s.state_group().size(); ++i) {
                std::vector<Real> broken = y;
                broken[static_cast<std::size_t>(i)] = value;
                const bool is_position =
                    s.velocities() == 6 * s.bodies() && i < s.group().size() && i % (s.group().size() / s.bodies()) < 3;
                const bool is_velocity =
                    i >= s.group().size() && s.velocities() == 6 * s.bodies() && (i - s.group().size()) % 6 < 3;
                // Positions and, in SO3xR3, linear velocities do not enter the accelerations.
                if (is_position || is_velocity) continue;
                CHECK(s.vector_field(0, broken.data(), z.data()) != Status::ok);
            }
    });
}

TEST_CASE("the rows in ambient coordinates are derivatives with respect to x, R, x' and omega", "[mechanics]") {
    for (const Named& named : spherical()) {
        const auto s = make_system(named.model, "SO3xR3");
        if (!s->has_ambient_jacobian()) continue;
        INFO(named.name);
        const int m = s->constraints(), size = s->group().size();
        const auto residuals = [&](const std::vector<Real>& y) {
            VecX rows(2 * m);
            s->position_residual(0, y.data(), rows.data());
            s->velocity_residual(0, y.data(), y.data() + size, rows.data() + m);
            return rows;
        };
        const std::vector<Real> y = initial_state(*s, named.model);
        MatX G = MatX::Constant(2 * m, static_cast<Eigen::Index>(y.size()), std::numeric_limits<Real>::quiet_NaN());
        s->ambient_jacobian(0, y.data(), y.data() + size, G.data());
        for (std::size_t k = 0; k < y.size(); ++k) {
            std::vector<Real> more = y, less = y;
            more[k] += 1, less[k] -= 1;  // exact: each row is linear in each coordinate
            const VecX slope = (residuals(more) - residuals(less)) / 2;
            CHECK((G.col(static_cast<Eigen::Index>(k)) - slope).norm() <= 100 * epsilon);
        }
    }
}
