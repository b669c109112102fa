// SPDX-License-Identifier: BSD-3-Clause
#include "engine/structure/tangent_frame.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// Solves of [M C^T; C 0] [a; lambda] = [f; c] at one state.
class Kkt {
  public:
    Kkt(System& system, const Real& t, const Real* y)
        : system_(system), t_(t), q_(system.q(y)), v_(Eigen::Map<const VecX>(system.v(y), system.velocities())) {}

    bool is_constrained() const { return system_.constraints() > 0; }
    /// M^{-1} f made to satisfy C a = 0: the projection in the mass metric.
    Status project(const VecX& f, VecX& a) { return solve(f.data(), VecX::Zero(system_.constraints()), a); }

    /// The w of least energy with C w = - D_xi (C v + b) along q xi^. With L_xi the derivative along xi,
    ///   D_xi (C v) = L_xi L_v Phi = 1/2 (L_xi L_v + L_v L_xi) Phi + 1/2 C [xi, v],
    /// and the symmetric part follows from the right-hand side of C v' = xi(v), which is quadratic in v:
    ///   1/2 (L_xi L_v + L_v L_xi) Phi + D_xi b = - (xi(v + xi) - xi(v - xi))/4.
    Status complete(const VecX& xi, VecX& w) {
        VecX plus(system_.constraints()), minus(plus), turned(plus), bracket(xi.size());
        const VecX forth = v_ + xi, back = v_ - xi;
        system_.acceleration_bias(t_, q_, forth.data(), plus.data());
        system_.acceleration_bias(t_, q_, back.data(), minus.data());
        system_.group().bracket(xi.data(), v_.data(), bracket.data());
        system_.apply_jacobian(t_, q_, bracket.data(), turned.data());
        return solve(nullptr, (plus - minus) / 4 - turned / 2, w);
    }

  private:
    Status solve(const Real* f, const VecX& c, VecX& a) {
        VecX lambda(c.size());
        return system_.solve_kkt(t_, q_, f, c.data(), a.data(), lambda.data());
    }

    System& system_;
    Real t_;
    const Real* q_;
    VecX v_;
};

/// The unit vectors of the mass metric along the coordinates, projected onto the null space of C.
Status project_coordinates(Kkt& kkt, const MatX& M, MatX& all) {
    all = M.diagonal().cwiseSqrt().cwiseInverse().asDiagonal();
    for (Eigen::Index i = 0; i < M.cols() && kkt.is_constrained(); ++i) {
        VecX a(M.rows());
        if (const Status status = kkt.project(M * all.col(i), a); status != Status::ok) return status;
        all.col(i) = a;
    }
    return Status::ok;
}

/// An orthonormal basis of the span of these columns in the metric M, of `count` vectors, by Gram-Schmidt with
/// pivoting. Each is orthogonalised twice, or cancellation would leave it oblique. The least length found before
/// normalisation is returned: round-off where the span is smaller.
Real orthonormalise(MatX& columns, const MatX& M, Eigen::Index count) {
    MatX basis(columns.rows(), count);
    Real least = 1;
    for (Eigen::Index k = 0; k < count; ++k) {
        Eigen::Index longest = 0;
        const VecX squares = columns.cwiseProduct(M * columns).colwise().sum();
        const Real square = squares.maxCoeff(&longest);
        least = min(least, Real(sqrt(max(square, Real(0)))));
        if (!(least > 0)) return 0;
        VecX a = columns.col(longest);
        for (int pass = 0; pass < 2; ++pass) a -= basis.leftCols(k) * (basis.leftCols(k).transpose() * (M * a)).eval();
        basis.col(k) = a / sqrt(a.dot(M * a));
        columns -= (basis.col(k) * (basis.col(k).transpose() * (M * columns))).eval();
    }
    columns = basis;
    return least;
}

}  // namespace

MatX times_mass(const System& system, const Real* q, const MatX& X) {
    const Eigen::Index n = system.velocities(), rows = system.mass_block();
    MatX blocks(rows, n), product(n, X.cols());
    system.mass(q, blocks.data());
    for (Eigen::Index i = 0; i < n; i += rows)
        product.middleRows(i, rows) = blocks.middleCols(i, rows) * X.middleRows(i, rows);
    return product;
}

TangentFrame tangent_frame(System& system, const Real& t, const Real* y, const Real& rate) {
    const Eigen::Index n = system.velocities(), k = n - system.constraint_rank().rank;
    const MatX M = times_mass(system, system.q(y), MatX::Identity(n, n));
    Kkt kkt(system, t, y);
    MatX xi;
    if (project_coordinates(kkt, M, xi) != Status::ok)
        return {{}, "the constraints cannot be solved for at this state"};
    // Of a projection onto k dimensions, the longest remaining column is no shorter than 1/sqrt(n).
    if (orthonormalise(xi, M, k) < 1 / Real(1 + 100 * n)) return {{}, "the constraints change their rank"};
    MatX vectors = MatX::Zero(2 * n, 2 * k);
    for (Eigen::Index a = 0; a < k; ++a) {
        VecX w = VecX::Zero(n);
        if (kkt.is_constrained() && kkt.complete(xi.col(a), w) != Status::ok)
            return {{}, "the constraints cannot be solved for at this state"};
        vectors.col(a) << xi.col(a), w;
        vectors.col(k + a).tail(n) = rate * xi.col(a);
    }
    return {vectors};
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
