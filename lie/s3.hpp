// SPDX-License-Identifier: BSD-3-Clause
//
// S^3, the unit quaternions, which cover the rotations twice.
//   element   a = (w, x, y, z), |a| = 1; stored in this order
//   algebra   R^3 scaled such that exp(u) turns by |u|: exp(u) = (cos t/2, sin t/2 u/t), t = |u|; bracket u x v
// In this scaling the algebra is so(3), and what depends only on it (dexp and its inverses) is that of SO(3).
// Sources: [hairer2006, Sec. IV.7], [celledoni2003cf].
#pragma once

#include "lie/so3.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

struct S3 {
    static constexpr int dim = 3, size = 4;
    using Algebra = Vec3;
    using Element = Eigen::Matrix<Real, 4, 1>;

    static Element load(const Real* q) { return Eigen::Map<const Element>(q); }
    static Algebra load_algebra(const Real* u) { return vec3(u); }
    static void save(const Element& a, Real* q) { Eigen::Map<Element>{q} = a; }
    static void save_algebra(const Algebra& u, Real* p) { store(u, p); }

    static Element make(const Real& w, const Vec3& v) { return Element(w, v[0], v[1], v[2]); }
    static Element identity() { return make(1, Vec3::Zero()); }
    static Element multiply(const Element& a, const Element& b) {
        const Vec3 u = a.tail<3>(), v = b.tail<3>();
        return make(a[0] * b[0] - u.dot(v), a[0] * v + b[0] * u + u.cross(v));
    }
    static Element inverse(const Element& a) { return make(a[0], -a.tail<3>()); }
    static Algebra bracket(const Algebra& u, const Algebra& v) { return u.cross(v); }
    static Algebra Ad(const Element& a, const Algebra& v) { return rotation(a) * v; }
    static Algebra coAd(const Element& a, const Algebra& p) { return rotation(a).transpose() * p; }

    /// R(a) = I + s (w hat(v) + hat(v)^2) with s = 2/|a|^2, a rotation for any a but zero.
    static Mat3 rotation(const Element& a) {
        const Real s = 2 / a.squaredNorm();
        return SO3::rotation(a.tail<3>(), a.tail<3>().squaredNorm(), s * a[0], s);
    }
    /// One of the two quaternions of a rotation, with w >= 0.
    static Element of_rotation(const Mat3& R) { return exp(SO3::log(R)); }

    /// (1 - (t^2/4) (1 - cos t/2)/(t/2)^2, sinc(t/2) u/2): finite at t = 0.
    static Element exp(const Algebra& u) {
        const Real quarter = u.squaredNorm() / 4;
        return make(1 - quarter * cosc(quarter), sinc(quarter) / 2 * u);
    }
    /// a e as a + a (e - 1), of e = exp(u) or cay(u).
    using Increment = Element;
    static Increment exp_increment(const Algebra& u) {
        const Real quarter = u.squaredNorm() / 4;
        return make(-quarter * cosc(quarter), sinc(quarter) / 2 * u);
    }
    /// With r = sqrt(1 + |u|^2/4): 1/r - 1 = -|u|^2/4/(r (1 + r)).
    static Increment cay_increment(const Algebra& u) {
        const Real quarter = u.squaredNorm() / 4, r = sqrt(1 + quarter);
        return make(-quarter / (r * (1 + r)), u / (2 * r));
    }
    static Element append(const Element& a, const Increment& e) { return a + multiply(a, e); }

    /// Inverse of exp for |u| < 2 pi. At a = -1 the axis is free.
    static Algebra log(const Element& a) {
        const Vec3 v = a.tail<3>();
        const Real sine = sqrt(v.squaredNorm());
        if (sine == 0) return a[0] > 0 ? Vec3(Vec3::Zero()) : Vec3(2 * pi() * Vec3::UnitX());
        return 2 * atan2(sine, a[0]) / sine * v;
    }
    static Algebra dexp(const Algebra& u, const Algebra& v) { return SO3::dexp(u, v); }
    static Algebra dexpinv(const Algebra& u, const Algebra& v) { return SO3::dexpinv(u, v); }
    static Algebra dexpinv_transpose(const Algebra& u, const Algebra& p) { return SO3::dexpinv_transpose(u, p); }

    /// (1, u/2)/sqrt(1 + |u|^2/4), above the Cayley map of SO(3).
    static Element cay(const Algebra& u) {
        const Real scale = 1 / sqrt(1 + u.squaredNorm() / 4);
        return make(scale, scale / 2 * u);
    }
    static Algebra dcayinv(const Algebra& u, const Algebra& v) { return SO3::dcayinv(u, v); }
    static Algebra dcayinv_transpose(const Algebra& u, const Algebra& p) { return SO3::dcayinv_transpose(u, p); }

    /// | |a|^2 - 1 |.
    static Real orthogonality_defect(const Element& a) { return abs(a.squaredNorm() - 1); }
    static Real squared_angle(const Algebra& u) { return u.squaredNorm(); }
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
