// SPDX-License-Identifier: BSD-3-Clause
//
// Independent evaluations with dense matrices: the groups in their matrix representations, exponentials by scaling,
// Taylor sum and squaring.
#pragma once

#include <Eigen/LU>
#include <random>

#include "lie/cotangent_so3.hpp"
#include "lie/pair.hpp"
#include "lie/rn.hpp"
#include "lie/s3.hpp"
#include "lie/se3.hpp"
#include "lie/so3.hpp"

namespace dense {

using namespace kreisel;

/// For algebra vectors of size one, up to a turn by 2 pi.
inline const Real tolerance = 400 * epsilon;

inline MatX matrix_exp(MatX A) {
    int squarings = 0;
    for (Real size = A.norm(); size > Real(1) / 4; size /= 2) ++squarings, A /= 2;
    MatX sum = MatX::Identity(A.rows(), A.cols()), term = sum;
    for (int k = 1; k < 40; ++k) term = term * A / Real(k), sum += term;
    for (int k = 0; k < squarings; ++k) sum = sum * sum;
    return sum;
}

inline MatX matrix_cay(const MatX& A) {
    const MatX I = MatX::Identity(A.rows(), A.cols());
    return (I - A / 2).inverse() * (I + A / 2);
}

/// Representation of elements and algebra vectors as square matrices.
template <class K>
struct Representation;

template <>
struct Representation<SO3> {
    static MatX element(const Mat3& R) { return R; }
    static MatX algebra(const Vec3& u) { return hat(u); }
};

/// By rotations, which do not distinguish a from -a: the laws do.
template <>
struct Representation<S3> {
    static MatX element(const S3::Element& a) { return S3::rotation(a); }
    static MatX algebra(const Vec3& u) { return hat(u); }
};

template <>
struct Representation<SE3> {
    static MatX element(const SE3::Element& g) {
        MatX G = MatX::Identity(4, 4);
        G.topLeftCorner(3, 3) = g.R;
        G.topRightCorner(3, 1) = g.x;
        return G;
    }
    static MatX algebra(const SE3::Algebra& u) {
        MatX U = MatX::Zero(4, 4);
        U.topLeftCorner(3, 3) = hat(u.w);
        U.topRightCorner(3, 1) = u.p;
        return U;
    }
};

/// In space axes, as SE(3) with R m as the translation.
template <>
struct Representation<CotangentSO3> {
    static MatX element(const CotangentSO3::Element& g) { return Representation<SE3>::element({g.R * g.m, g.R}); }
    static MatX algebra(const CotangentSO3::Algebra& u) { return Representation<SE3>::algebra(u); }
};

template <int n>
struct Representation<Rn<n>> {
    static MatX element(const typename Rn<n>::Element& x) {
        MatX X = MatX::Identity(n + 1, n + 1);
        X.topRightCorner(n, 1) = x;
        return X;
    }
    static MatX algebra(const typename Rn<n>::Algebra& u) {
        MatX U = MatX::Zero(n + 1, n + 1);
        U.topRightCorner(n, 1) = u;
        return U;
    }
};

template <class A, class B>
struct Representation<Pair<A, B>> {
    static MatX blocks(const MatX& a, const MatX& b) {
        MatX M = MatX::Zero(a.rows() + b.rows(), a.rows() + b.rows());
        M.topLeftCorner(a.rows(), a.rows()) = a;
        M.bottomRightCorner(b.rows(), b.rows()) = b;
        return M;
    }
    static MatX element(const typename Pair<A, B>::Element& g) {
        return blocks(Representation<A>::element(g.first), Representation<B>::element(g.second));
    }
    static MatX algebra(const typename Pair<A, B>::Algebra& u) {
        return blocks(Representation<A>::algebra(u.first), Representation<B>::algebra(u.second));
    }
};

/// Deterministic random vectors; `size` scales them.
class Random {
  public:
    explicit Random(unsigned seed) : engine_(seed) {}
    Real number() { return Real(distribution_(engine_)); }
    VecX vector(int n, const Real& size) {
        VecX v(n);
        for (int i = 0; i < n; ++i) v[i] = size * number();
        return v;
    }

  private:
    std::mt19937 engine_;
    std::uniform_real_distribution<double> distribution_{-1, 1};
};

}  // namespace dense
