// SPDX-License-Identifier: BSD-3-Clause
//
// T*SO(3), left-trivialised: rotations with a covector each, as the semidirect product of SO(3) with so(3)*.
//   element   (R, m): R in SO(3), m in so(3)* = R^3; product (R, m) (S, n) = (R S, S^T m + n); stored R column by
//             column, then m. In space axes, with x = R m, it is SE(3): (R, x) (S, y) = (R S, x + R y)
//   algebra   (u, n): u in so(3), n in so(3)*, with the bracket of se(3): [(u, n), (v, k)] = (u x v, u x k - v x n)
//   curves    (R, m)' = (R, m) (u, n) is R' = R hat(u), m' = m x u + n: along (u, 0) the covector moves on its
//             coadjoint orbit, the sphere |m|, m = R(t)^T R(0) m(0)
// exp(u, n) = (exp(u), dexp_{-u}(n)): (u, 0) turns by R = exp(u) and m becomes R^T m, to the last digit without n.
// Maps of the algebra alone are those of lie/se3.hpp, of which (u, n) is (p, w) = (n, u).
// Sources: [engofaltinsen2001, Sec. 2], [hairer2006, Sec. VII.5].
#pragma once

#include "lie/se3.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

struct CotangentSO3 {
    static constexpr int dim = 6, size = 12;
    using Algebra = SE3::Algebra;
    struct Element {
        Mat3 R;
        Vec3 m;
    };

    static Element load(const Real* q) { return {mat3(q), vec3(q + 9)}; }
    static Algebra load_algebra(const Real* u) { return {vec3(u + 3), vec3(u)}; }
    static void save(const Element& g, Real* q) { store(g.R, q), store(g.m, q + 9); }
    static void save_algebra(const Algebra& u, Real* z) { store(u.w, z), store(u.p, z + 3); }

    static Element identity() { return {Mat3::Identity(), Vec3::Zero()}; }
    static Element multiply(const Element& a, const Element& b) { return {a.R * b.R, b.R.transpose() * a.m + b.m}; }
    static Element inverse(const Element& a) { return {a.R.transpose(), -(a.R * a.m)}; }
    static Algebra bracket(const Algebra& u, const Algebra& v) { return SE3::bracket(u, v); }
    /// (R v, R (k + m x v)).
    static Algebra Ad(const Element& g, const Algebra& v) { return {g.R * (v.p + g.m.cross(v.w)), g.R * v.w}; }
    static Algebra coAd(const Element& g, const Algebra& c) {
        const Vec3 f = g.R.transpose() * c.p;
        return {f, g.R.transpose() * c.w - g.m.cross(f)};
    }

    static Element exp(const Algebra& u) {
        const Real s = u.w.squaredNorm(), b = cosc(s);
        return {SO3::rotation(u.w, s, sinc(s), b), exp_covector(u, s, b)};
    }
    static Vec3 exp_covector(const Algebra& u, const Real& s, const Real& b) {
        const Vec3 wp = u.w.cross(u.p);
        return u.p - b * wp + sincc(s) * u.w.cross(wp);
    }

    /// The covector is added to in the same way, R^T m = m + E^T m: |m| is kept as R is.
    struct Increment {
        SO3::Increment turn;
        Vec3 n;
    };
    static Increment exp_increment(const Algebra& u) {
        const Real s = u.w.squaredNorm(), b = cosc(s);
        return {{u.w, sinc(s), b}, exp_covector(u, s, b)};
    }
    static Increment cay_increment(const Algebra& u) { return {SO3::cay_increment(u.w), cay_covector(u)}; }
    static Element append(const Element& g, const Increment& e) {
        return {SO3::append(g.R, e.turn), g.m + (SO3::turned(g.m, e.turn) + e.n)};
    }
    static Algebra log(const Element& g) {
        const Vec3 w = SO3::log(g.R);
        return {SO3::dexpinv(-w, g.m), w};
    }
    static Algebra dexp(const Algebra& u, const Algebra& v) { return SE3::dexp(u, v); }
    static Algebra dexpinv(const Algebra& u, const Algebra& v) { return SE3::dexpinv(u, v); }
    static Algebra dexpinv_transpose(const Algebra& u, const Algebra& c) { return SE3::dexpinv_transpose(u, c); }

    /// (cay(u), (I + hat(u)/2)^{-1} n).
    static Element cay(const Algebra& u) { return {SO3::cay(u.w), cay_covector(u)}; }
    static Vec3 cay_covector(const Algebra& u) {
        const Real a = 1 / (1 + u.w.squaredNorm() / 4);
        return a * (u.p - u.w.cross(u.p) / 2 + u.w.dot(u.p) / 4 * u.w);
    }
    static Algebra dcayinv(const Algebra& u, const Algebra& v) { return SE3::dcayinv(u, v); }
    static Algebra dcayinv_transpose(const Algebra& u, const Algebra& c) { return SE3::dcayinv_transpose(u, c); }

    static Real orthogonality_defect(const Element& g) { return SO3::orthogonality_defect(g.R); }
    static Real squared_angle(const Algebra& u) { return u.w.squaredNorm(); }
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
