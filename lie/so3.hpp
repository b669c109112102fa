// SPDX-License-Identifier: BSD-3-Clause
//
// SO(3), the rotations.
//   element   R in R^{3x3}, R^T R = I, det R = 1; stored column by column
//   algebra   so(3) = skew matrices hat(w), written as w in R^3; bracket [u, v] = u x v
//   matrices  exp, Ad, ad are those of the 3x3 representation
// All differentials are left-trivialised where they act on a curve q(t) = q0 exp(u(t)): with q' = q hat(v),
//   u' = dexp^{-1}_{-u}(v) = v + 1/2 [u, v] + 1/12 [u, [u, v]] - ...
// Covectors p are vectors in R^3 too, with p . v as their value at v.
// `dexp`, `dexpinv` below are the right-trivialised maps of the literature; lie/power.hpp converts them, in one place.
// Sources: [hairer2006, Sec. IV.7 and IV.8], [iserles2000], [celledoniowren2003, App. B].
#pragma once

#include "lie/linear.hpp"
#include "lie/small_angle.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

struct SO3 {
    static constexpr int dim = 3, size = 9;
    using Algebra = Vec3;
    using Element = Mat3;

    static Element load(const Real* q) { return mat3(q); }
    static Algebra load_algebra(const Real* u) { return vec3(u); }
    static void save(const Element& R, Real* q) { store(R, q); }
    static void save_algebra(const Algebra& u, Real* p) { store(u, p); }

    static Element identity() { return Mat3::Identity(); }
    static Element multiply(const Element& A, const Element& B) { return A * B; }
    static Element inverse(const Element& A) { return A.transpose(); }
    static Algebra bracket(const Algebra& u, const Algebra& v) { return u.cross(v); }
    static Algebra Ad(const Element& R, const Algebra& v) { return R * v; }
    static Algebra coAd(const Element& R, const Algebra& p) { return R.transpose() * p; }

    /// I + a hat(u) + b hat(u)^2, entry by entry: 1 + b (u u^T - s I) + a hat(u).
    static Mat3 rotation(const Vec3& u, const Real& s, const Real& a, const Real& b) {
        const Real bx = b * u[0], by = b * u[1], bz = b * u[2], d = 1 - b * s;
        const Real ax = a * u[0], ay = a * u[1], az = a * u[2];
        const Real xy = bx * u[1], xz = bx * u[2], yz = by * u[2];
        Mat3 E;
        E << d + bx * u[0], xy - az, xz + ay,  //
            xy + az, d + by * u[1], yz - ax,   //
            xz - ay, yz + ax, d + bz * u[2];
        return E;
    }

    /// exp(u) = I + sin t/t hat(u) + (1 - cos t)/t^2 hat(u)^2, t = |u| (Rodrigues).
    static Element exp(const Algebra& u) {
        const Real s = u.squaredNorm();
        return rotation(u, s, sinc(s), cosc(s));
    }

    /// R (I + E) as R + R E with E = a hat(u) + b hat(u)^2, of exp(u) or cay(u).
    struct Increment {
        Vec3 u;
        Real a, b;
    };
    static Increment exp_increment(const Algebra& u) {
        const Real s = u.squaredNorm();
        return {u, sinc(s), cosc(s)};
    }
    static Increment cay_increment(const Algebra& u) {
        const Real a = 1 / (1 + u.squaredNorm() / 4);
        return {u, a, a / 2};
    }
    static Element append(const Element& R, const Increment& e) {
        Element out;
        for (int i = 0; i < 3; ++i) {
            const Vec3 row = R.row(i);
            out.row(i) = row + turned(row, e);
        }
        return out;
    }
    /// E^T p = b u x (u x p) - a u x p: what a row of R is changed by, and a covector.
    static Vec3 turned(const Vec3& p, const Increment& e) {
        const Vec3 c = e.u.cross(p);
        return (e.b * e.u).cross(c) - e.a * c;
    }

    /// Inverse of exp, |log R| <= pi; at pi the axis is determined up to sign. For R near SO(3) it is the logarithm of
    /// a nearby rotation; NaN where R is not finite or far off.
    static Algebra log(const Element& R);

    /// dexp_u(v) = v + (1 - cos t)/t^2 u x v + (t - sin t)/t^3 u x (u x v).
    static Algebra dexp(const Algebra& u, const Algebra& v) {
        const Real s = u.squaredNorm();
        const Vec3 uv = u.cross(v);
        return v + cosc(s) * uv + sincc(s) * u.cross(uv);
    }

    /// dexp_u^{-1}(v) = v - 1/2 u x v + (1 - (t/2) cot(t/2))/t^2 u x (u x v); singular at t = 2 pi.
    static Algebra dexpinv(const Algebra& u, const Algebra& v) {
        const Vec3 uv = u.cross(v);
        return v - uv / 2 + cotc(u.squaredNorm()) * u.cross(uv);
    }
    /// hat(u)^T = hat(-u).
    static Algebra dexpinv_transpose(const Algebra& u, const Algebra& p) { return dexpinv(-u, p); }

    /// cay(u) = (I - hat(u)/2)^{-1} (I + hat(u)/2): rotation by 2 atan(t/2) about u.
    static Element cay(const Algebra& u) {
        const Real s = u.squaredNorm(), a = 1 / (1 + s / 4);
        return rotation(u, s, a, a / 2);
    }

    /// dcay_u^{-1}(v) = v - 1/2 u x v + 1/4 (u.v) u, exactly.
    static Algebra dcayinv(const Algebra& u, const Algebra& v) { return v - u.cross(v) / 2 + u.dot(v) / 4 * u; }
    static Algebra dcayinv_transpose(const Algebra& u, const Algebra& p) { return dcayinv(-u, p); }

    /// |R^T R - I| (Frobenius).
    static Real orthogonality_defect(const Element& R) { return (R.transpose() * R - Mat3::Identity()).norm(); }

    /// Squared angle that a chart must keep below (2 pi)^2.
    static Real squared_angle(const Algebra& u) { return u.squaredNorm(); }
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
