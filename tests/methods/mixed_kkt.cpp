// SPDX-License-Identifier: BSD-3-Clause
//
// KKT systems with C^T at one configuration and C at another, a step apart, against their two equations by dense
// matrices.
#include "methods/implicit/mixed_kkt.hpp"

#include <Eigen/Cholesky>

#include "tests/methods/linkages.hpp"

using namespace kreisel;
using namespace models;
using namespace stepping;
using namespace linkages;

namespace {

MatX jacobian_at(System& s, const Configuration& at) {
    MatX C(s.constraints(), s.velocities());
    s.jacobian(at.t, at.q, C.data());
    return C;
}

MatX mass_at(System& s, const Real* q) {
    const Eigen::Index n = s.velocities(), block = s.mass_block();
    MatX blocks(block, n), M = MatX::Zero(n, n);
    s.mass(q, blocks.data());
    for (Eigen::Index i = 0; i < n; i += block) M.block(i, i, block, block) = blocks.middleCols(i, block);
    return M;
}

/// Largest violation of M a + C_1^T lambda = f and C_2 a = c, relative to the solution.
Real violation(System& s, const Configuration& transposed, const Configuration& rows, const VecX& f, const VecX& c,
               const VecX& a, const VecX& lambda) {
    const VecX forces = mass_at(s, transposed.q) * a + jacobian_at(s, transposed).transpose() * lambda - f;
    const VecX accelerations = jacobian_at(s, rows) * a - c;
    return max(Real(forces.norm()), Real(accelerations.norm())) /
           max(Real(1), max(Real(a.norm()), Real(lambda.norm())));
}

std::vector<Named> mechanisms() {
    std::vector<Named> all = {{"double_pendulum", standard("double_pendulum")},
                              {"chain", linked(5, {{ground, 0}, {0, 1}, {1, 2}, {2, 3}, {3, 4}})},
                              {"closed loop", closed_loop()},
                              {"free body", standard("forced_free_body")}};
    all.push_back({"planar four-bar", planar_four_bar()});
    return all;
}

}  // namespace

TEST_CASE("KKT systems with C and C^T at two configurations are solved to round-off", "[methods]") {
    for (const Named& named : mechanisms())
        for (const std::string& formulation : applicable(named.model)) {
            INFO(named.name << " as " << formulation);
            Trip here(named.model, formulation, method("rkmk/rk4"), "position_velocity"),
                there(named.model, formulation, method("rkmk/rk4"), "position_velocity");
            REQUIRE(there.run(Real(1) / 64, 4) == Status::ok);
            System& s = *here.system;
            const Configuration transposed{0, here.y.data()}, rows{Real(1) / 64, there.y.data()};
            const Eigen::Index n = s.velocities(), m = s.constraints();
            VecX f(n), c(m), a(n), lambda = VecX::Zero(m), v(n);
            for (Eigen::Index i = 0; i < n; ++i) f[i] = sin(Real(i + 1)), v[i] = cos(Real(2 * i));
            s.apply_jacobian(rows.t, rows.q, v.data(), c.data());  // in the range of C, where rows are redundant
            MixedKkt mixed(s);
            REQUIRE(mixed.solve(transposed, rows, f.data(), c.data(), a.data(), lambda.data()) == Status::ok);
            const Real slack = 10000000 * epsilon;
            CHECK(violation(s, transposed, rows, f, c, a, lambda) <= slack);
            // Both configurations matter: the solution for one of them alone violates the equations.
            if (m == 0) continue;
            CHECK(violation(s, rows, rows, f, c, a, lambda) > slack);
            CHECK(violation(s, transposed, transposed, f, c, a, lambda) > slack);
        }
}
