// SPDX-License-Identifier: BSD-3-Clause
#include "tests/judges/steps/dense.hpp"

#include <Eigen/LU>
#include <vector>

#include "lie/cotangent_so3.hpp"
#include "lie/pair.hpp"
#include "lie/power.hpp"
#include "lie/rn.hpp"
#include "lie/s3.hpp"
#include "lie/se3.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

MatX identity_like(const MatX& a) { return MatX::Identity(a.rows(), a.cols()); }

MatX skew(const VecX& w) {
    MatX W = MatX::Zero(3, 3);
    W(2, 1) = w[0], W(0, 2) = w[1], W(1, 0) = w[2];
    return W - MatX(W.transpose());
}

/// Of a quaternion stored as (w, v): R = I + 2 w hat(v) + 2 hat(v)^2.
MatX rotation_of(const Real* q) {
    const MatX V = skew(Eigen::Map<const VecX>(q + 1, 3));
    return MatX::Identity(3, 3) + MatX(2 * q[0] * V) + 2 * MatX(V * V);
}

/// Bernoulli numbers B_0 ... B_n with B_1 = -1/2, from sum_{k<=m} binomial(m+1, k) B_k = 0.
std::vector<Real> bernoulli(int n) {
    std::vector<Real> B = {1};
    for (int m = 1; m <= n; ++m) {
        Real binomial = 1, sum = 0;
        for (int k = 0; k < m; ++k) {
            sum += binomial * B[static_cast<std::size_t>(k)];
            binomial = binomial * (m + 1 - k) / (k + 1);
        }
        B.push_back(-sum / (m + 1));
    }
    return B;
}

}  // namespace

MatrixGroup matrix_so3() {
    return {.name = "SO3",
            .group = std::make_shared<Power<SO3>>(1),
            .hat = skew,
            .vee = [](const MatX& W) -> VecX { return Vec3(W(2, 1), W(0, 2), W(1, 0)); },
            .matrix = [](const Real* q) -> MatX { return Eigen::Map<const Mat3>(q); }};
}

MatrixGroup matrix_so3xr3() {
    const auto hat = [](const VecX& u) {  // u = (p, w), hat(u) = (hat(w), [0 p; 0 0])
        MatX U = MatX::Zero(7, 7);
        U.topLeftCorner(3, 3) = skew(u.tail(3));
        U.block(3, 6, 3, 1) = u.head(3);
        return U;
    };
    const auto vee = [](const MatX& U) {
        VecX u(6);
        u << U(3, 6), U(4, 6), U(5, 6), U(2, 1), U(0, 2), U(1, 0);
        return u;
    };
    const auto matrix = [](const Real* q) {  // stored x, then R column by column
        MatX g = MatX::Identity(7, 7);
        g.block(3, 6, 3, 1) = Eigen::Map<const Vec3>(q);
        g.topLeftCorner(3, 3) = Eigen::Map<const Mat3>(q + 3);
        return g;
    };
    return {.name = "SO3xR3",
            .group = std::make_shared<Power<Pair<Rn<3>, SO3>>>(1),
            .hat = hat,
            .vee = vee,
            .matrix = matrix};
}

MatrixGroup matrix_s3() {
    MatrixGroup group = matrix_so3();
    group.name = "S3", group.group = std::make_shared<Power<S3>>(1), group.matrix = rotation_of;
    return group;
}

MatrixGroup matrix_s3xr3() {
    MatrixGroup group = matrix_so3xr3();
    const auto matrix = [](const Real* q) {  // stored x, then a quaternion
        MatX g = MatX::Identity(7, 7);
        g.block(3, 6, 3, 1) = Eigen::Map<const Vec3>(q);
        g.topLeftCorner(3, 3) = rotation_of(q + 3);
        return g;
    };
    group.name = "S3xR3", group.group = std::make_shared<Power<Pair<Rn<3>, S3>>>(1), group.matrix = matrix;
    return group;
}

MatrixGroup matrix_se3() {
    const auto hat = [](const VecX& u) {  // u = (p, w)
        MatX U = MatX::Zero(4, 4);
        U.topLeftCorner(3, 3) = skew(u.tail(3));
        U.topRightCorner(3, 1) = u.head(3);
        return U;
    };
    const auto vee = [](const MatX& U) {
        VecX u(6);
        u << U(0, 3), U(1, 3), U(2, 3), U(2, 1), U(0, 2), U(1, 0);
        return u;
    };
    const auto matrix = [](const Real* q) {  // stored x, then R column by column
        MatX g = MatX::Identity(4, 4);
        g.topRightCorner(3, 1) = Eigen::Map<const Vec3>(q);
        g.topLeftCorner(3, 3) = Eigen::Map<const Mat3>(q + 3);
        return g;
    };
    return {.name = "SE3", .group = std::make_shared<Power<SE3>>(1), .hat = hat, .vee = vee, .matrix = matrix};
}

MatrixGroup matrix_cotangent_so3() {
    const MatrixGroup se3 = matrix_se3();
    const auto swapped = [](const VecX& u) {  // (u, n) and (p, w)
        VecX v(6);
        v << u.tail(3), u.head(3);
        return v;
    };
    const auto matrix = [](const Real* q) {  // stored R column by column, then m
        const Mat3 R = Eigen::Map<const Mat3>(q);
        MatX g = MatX::Identity(4, 4);
        g.topLeftCorner(3, 3) = R;
        g.topRightCorner(3, 1) = R * Eigen::Map<const Vec3>(q + 9);
        return g;
    };
    return {.name = "T*SO3",
            .group = std::make_shared<Power<CotangentSO3>>(1),
            .hat = [=](const VecX& u) { return se3.hat(swapped(u)); },
            .vee = [=](const MatX& U) -> VecX { return swapped(se3.vee(U)); },
            .matrix = matrix};
}

MatX dense_exp(const MatX& a) {
    int squarings = 0;
    Real scale = 1;
    for (; a.cwiseAbs().sum() * scale > Real(1) / 2; scale /= 2) ++squarings;
    MatX sum = identity_like(a), term = sum;
    for (int k = 1; k <= 30; ++k) {  // (1/2)^31/31! < 1e-42
        term = MatX(term * a) * (scale / k);
        sum += term;
    }
    for (; squarings > 0; --squarings) sum = MatX(sum * sum);
    return sum;
}

MatX dense_log(const MatX& a) {
    const MatX I = identity_like(a);
    const auto first = [&](const MatX& b) { return MatX(MatX(b + I).partialPivLu().solve(MatX(b - I)) * 2); };
    MatX u = first(a);
    // u is a function of a and commutes with it, so exp(-u) a = exp(error); `first` leaves a twelfth of its cube.
    for (int i = 0; i < 5; ++i) u += first(MatX(dense_exp(-u) * a));
    return u;
}

MatX dense_cay(const MatX& a) {
    const MatX I = identity_like(a);
    return MatX(I - a / 2).partialPivLu().solve(MatX(I + a / 2));
}

MatX dense_ad(const MatrixGroup& g, const VecX& u) {
    const MatX U = g.hat(u);
    MatX ad(u.size(), u.size());
    for (Eigen::Index j = 0; j < u.size(); ++j) {
        const MatX E = g.hat(VecX::Unit(u.size(), j));
        ad.col(j) = g.vee(MatX(U * E) - MatX(E * U));
    }
    return ad;
}

VecX dense_dexpinv_left(const MatrixGroup& g, const VecX& u, const VecX& v) {
    const MatX minus_ad = -dense_ad(g, u);
    MatX sum = identity_like(minus_ad), term = sum;
    for (int k = 1; k <= 80; ++k) {  // entire series; |u| stays of order one
        term = MatX(term * minus_ad) / (k + 1);
        sum += term;
    }
    return sum.partialPivLu().solve(v);
}

VecX dense_truncated_dexpinv_left(const MatrixGroup& g, const VecX& u, const VecX& v, int brackets) {
    const MatX ad = dense_ad(g, u);
    const auto B = bernoulli(brackets);
    VecX power = v, sum = v;
    Real factorial = 1;
    for (int p = 1; p <= brackets; ++p) {
        power = VecX(ad * power);
        factorial *= p;
        const Real sign = p % 2 == 0 ? 1 : -1;
        sum += sign * B[static_cast<std::size_t>(p)] / factorial * power;
    }
    return sum;
}

VecX dense_dcayinv_left(const MatrixGroup& g, const VecX& u, const VecX& v) {
    const MatX U = g.hat(u), I = identity_like(U);
    return g.vee(MatX(MatX(I + U / 2) * g.hat(v)) * MatX(I - U / 2));
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
