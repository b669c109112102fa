// SPDX-License-Identifier: BSD-3-Clause
//
// C v, C^T lambda, M^{-1} f and solves with prepared factors, all without dense matrices, against the dense matrices
// of the same system.
#include <Eigen/Cholesky>

#include "mechanics/forwarding_system.hpp"
#include "tests/mechanics/models/models.hpp"

using namespace kreisel;
using namespace models;

namespace {

VecX wavy(Eigen::Index n, const Real& frequency) {
    VecX v(n);
    for (Eigen::Index i = 0; i < n; ++i) v[i] = sin(frequency * Real(i + 1));
    return v;
}

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

/// The objection to the products of a system, relative to their terms.
std::string products_objection(System& s, const Real& t, const std::vector<Real>& y) {
    const Eigen::Index n = s.velocities(), m = s.constraints();
    MatX C(m, n);
    s.jacobian(t, y.data(), C.data());
    const VecX v = wavy(n, 2), lambda = wavy(m, 3);
    VecX Cv(m), f(n), a(n), Ma = VecX::Zero(n);
    s.apply_jacobian(t, y.data(), v.data(), Cv.data());
    s.apply_jacobian_transpose(t, y.data(), lambda.data(), f.data());
    s.solve_mass(y.data(), v.data(), a.data());
    const Eigen::Index block = s.mass_block();
    MatX blocks(block, n);
    s.mass(y.data(), blocks.data());
    for (Eigen::Index i = 0; i < n; i += block)
        Ma.segment(i, block) = blocks.middleCols(i, block) * a.segment(i, block);
    const Real slack = 64 * epsilon;
    const VecX rows = C.cwiseAbs() * v.cwiseAbs(), columns = C.cwiseAbs().transpose() * lambda.cwiseAbs();
    for (Eigen::Index i = 0; i < m; ++i)
        if (!(abs(Cv[i] - C.row(i).dot(v)) <= slack * max(rows[i], Real(1)))) return "C v";
    for (Eigen::Index i = 0; i < n; ++i)
        if (!(abs(f[i] - C.col(i).dot(lambda)) <= slack * max(columns[i], Real(1)))) return "C^T lambda";
    const Real inertias = blocks.cwiseAbs().maxCoeff() * a.cwiseAbs().maxCoeff();
    return (Ma - v).norm() <= slack * max(inertias, Real(1)) ? "" : "M^{-1} f";
}

/// A system without products of its own: those of the base class, from dense matrices with one entry spoilt.
class Spoilt final : public ForwardingSystem {
  public:
    Spoilt(System& healthy, bool in_jacobian) : ForwardingSystem(healthy), in_jacobian_(in_jacobian) {}
    void solve_mass(const Real* q, const Real* f, Real* a) const override { System::solve_mass(q, f, a); }
    void apply_jacobian(const Real& t, const Real* q, const Real* v, Real* product) const override {
        System::apply_jacobian(t, q, v, product);
        if (in_jacobian_) product[0] += Real(1) / 1000;
    }
    void apply_jacobian_transpose(const Real& t, const Real* q, const Real* lambda, Real* f) const override {
        System::apply_jacobian_transpose(t, q, lambda, f);
        if (!in_jacobian_) f[0] += Real(1) / 1000;
    }

  private:
    bool in_jacobian_;
};

}  // namespace

TEST_CASE("C v, C^T lambda and M^{-1} f are those of the dense matrices", "[mechanics]") {
    for_each_system([](System& s, const std::vector<Real>& y) { CHECK(products_objection(s, Real(3) / 10, y) == ""); });
}

TEST_CASE("a wrong product is seen", "[mechanics][control]") {
    const Model model = standard("double_pendulum");
    const auto system = make_system(model, "SE3");
    const std::vector<Real> y = initial_state(*system, model);
    Spoilt product(*system, true), transpose(*system, false);
    CHECK(products_objection(product, 0, y) == "C v");
    CHECK(products_objection(transpose, 0, y) == "C^T lambda");
}

// Products of zeros that are left out change how the others are fused, and with it the last bits.
TEST_CASE("a solve without forces equals one with zero forces up to round-off", "[mechanics]") {
    for_each_system([](System& s, const std::vector<Real>& y) {
        const VecX none = VecX::Zero(s.velocities()), v = wavy(s.velocities(), Real(1) / 2);
        VecX c(s.constraints()), a = none, without = v;
        s.apply_jacobian(0, y.data(), v.data(), c.data());
        REQUIRE(s.solve_kkt(0, y.data(), none.data(), c.data(), a.data(), nullptr) == Status::ok);
        REQUIRE(s.solve_kkt(0, y.data(), nullptr, c.data(), without.data(), nullptr) == Status::ok);
        CHECK((a - without).norm() <= 1000 * epsilon * a.norm());
    });
}

TEST_CASE("prepared solves equal single ones, right-hand side after right-hand side", "[mechanics]") {
    for_each_system([](System& s, const std::vector<Real>& y) {
        const Real t = Real(3) / 10;
        const Eigen::Index n = s.velocities(), m = s.constraints();
        VecX a(n), lambda(m), C_force(n);
        REQUIRE(s.prepare_kkt(t, y.data()) == Status::ok);
        for (const int k : {1, 2, 3}) {
            // In the range of C, so that redundant rows have a solution.
            const VecX f = wavy(n, k), v = wavy(n, Real(k) / 2);
            VecX c(m);
            s.apply_jacobian(t, y.data(), v.data(), c.data());
            REQUIRE(s.solve_prepared(t, y.data(), f.data(), c.data(), a.data(), lambda.data()) == Status::ok);
            VecX residual(m);
            s.apply_jacobian(t, y.data(), a.data(), residual.data());
            const Real condition = s.kkt_round_off() / epsilon;
            const Real slack = 4000 * condition * epsilon;
            CHECK((residual - c).norm() <= slack * max(Real(1), Real(c.norm() + a.norm())));
            // M a + C^T lambda = f, even if lambda is not unique.
            s.apply_jacobian_transpose(t, y.data(), lambda.data(), C_force.data());
            VecX rest = f - C_force, acceleration(n);
            s.solve_mass(y.data(), rest.data(), acceleration.data());
            CHECK((acceleration - a).norm() <= slack * max(Real(1), Real(a.norm() + lambda.norm())));
        }
    });
}

TEST_CASE("multipliers of least norm follow from any that belong to the same forces", "[mechanics]") {
    int seen = 0;
    for (const Named& named : all()) {
        if (has_independent_rows(named.model)) continue;
        INFO(named.name);
        ++seen;
        auto s = make_system(named.model, "SO3xR3");
        const std::vector<Real> y = initial_state(*s, named.model);
        const Eigen::Index n = s->velocities(), m = s->constraints();
        const VecX f = wavy(n, 1), c = VecX::Zero(m);
        VecX a(n), least(m), lambda(m);
        REQUIRE(s->solve_kkt(0, y.data(), f.data(), c.data(), a.data(), least.data()) == Status::ok);
        REQUIRE(s->prepare_kkt(0, y.data()) == Status::ok);
        REQUIRE(s->solve_prepared(0, y.data(), f.data(), c.data(), a.data(), lambda.data()) == Status::ok);
        const Real size = least.norm(), slack = 100000 * epsilon * max(Real(1), lambda.norm());
        CHECK((lambda - least).norm() > size / 1000);  // another one
        REQUIRE(s->minimise_multipliers(0, y.data(), lambda.data()) == Status::ok);
        CHECK((lambda - least).norm() <= slack);
    }
    CHECK(seen >= 2);
}
