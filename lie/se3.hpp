// SPDX-License-Identifier: BSD-3-Clause
//
// SE(3), the rigid displacements.
//   element   (x, R): x in R^3, R in SO(3); 4x4 matrix [[R, x], [0, 1]]; stored x, then R column by column
//   algebra   u = (p, w): p the translational part, w the rotational part; 4x4 matrix [[hat(w), p], [0, 0]]
//   covector  (f, m), whose value at (p, w) is f.p + m.w: a force and a torque where (p, w) is a velocity
//   bracket   [(p1, w1), (p2, w2)] = (w1 x p2 - w2 x p1, w1 x w2)
// se(3) is so(3) over the dual numbers w + eps p. Every map of SO(3) that is a polynomial in crosses with
// coefficients in s = |w|^2 carries over by differentiation, d/d eps s = 2 w.p; this gives the formulas below.
// Sources: [hairer2006, Sec. IV.7], [iserles2000], [bruelscardona2010]; the Cayley map is that of the 4x4 matrices
// (the 6x6 representation has another one).
#pragma once

#include "lie/so3.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

struct SE3 {
    static constexpr int dim = 6, size = 12;
    struct Algebra {
        Vec3 p, w;
    };
    struct Element {
        Vec3 x;
        Mat3 R;
    };

    static Element load(const Real* q) { return {vec3(q), mat3(q + 3)}; }
    static Algebra load_algebra(const Real* u) { return {vec3(u), vec3(u + 3)}; }
    static void save(const Element& g, Real* q) { store(g.x, q), store(g.R, q + 3); }
    static void save_algebra(const Algebra& u, Real* p) { store(u.p, p), store(u.w, p + 3); }

    static Element identity() { return {Vec3::Zero(), Mat3::Identity()}; }
    static Element multiply(const Element& a, const Element& b) { return {a.x + a.R * b.x, a.R * b.R}; }
    static Element inverse(const Element& a) { return {-(a.R.transpose() * a.x), a.R.transpose()}; }
    static Algebra bracket(const Algebra& u, const Algebra& v) {
        return {u.w.cross(v.p) - v.w.cross(u.p), u.w.cross(v.w)};
    }
    static Algebra Ad(const Element& g, const Algebra& v) {
        const Vec3 w = g.R * v.w;
        return {g.R * v.p + g.x.cross(w), w};
    }
    /// (R^T f, R^T (m - x x f)).
    static Algebra coAd(const Element& g, const Algebra& c) {
        return {g.R.transpose() * c.p, g.R.transpose() * (c.w - g.x.cross(c.p))};
    }

    /// exp(p, w) = (dexp_w(p), exp(w)): the translation is p + cosc w x p + sincc w x (w x p).
    static Element exp(const Algebra& u) {
        const Real s = u.w.squaredNorm(), b = cosc(s);
        return {exp_translation(u, s, b), SO3::rotation(u.w, s, sinc(s), b)};
    }
    static Vec3 exp_translation(const Algebra& u, const Real& s, const Real& b) {
        const Vec3 wp = u.w.cross(u.p);
        return u.p + b * wp + sincc(s) * u.w.cross(wp);
    }

    struct Increment {
        Vec3 x;
        SO3::Increment turn;
    };
    static Increment exp_increment(const Algebra& u) {
        const Real s = u.w.squaredNorm(), b = cosc(s);
        return {exp_translation(u, s, b), {u.w, sinc(s), b}};
    }
    static Increment cay_increment(const Algebra& u) { return {cay_translation(u), SO3::cay_increment(u.w)}; }
    static Element append(const Element& g, const Increment& e) { return {g.x + g.R * e.x, SO3::append(g.R, e.turn)}; }

    static Algebra log(const Element& g) {
        const Vec3 w = SO3::log(g.R);
        return {SO3::dexpinv(w, g.x), w};
    }

    /// v + f1 [u, v] + f2 [u, [u, v]] with coefficients f(s + eps 2 w.p) over the dual numbers.
    static Algebra dual_polynomial(const Algebra& u, const Algebra& v, const Real& f1, const Real& f1_ds,
                                   const Real& f2, const Real& f2_ds) {
        const Algebra uv = bracket(u, v), uuv = bracket(u, uv);
        const Real ds = 2 * u.w.dot(u.p);
        return {v.p + f1 * uv.p + f2 * uuv.p + ds * (f1_ds * uv.w + f2_ds * uuv.w), v.w + f1 * uv.w + f2 * uuv.w};
    }

    static Algebra dexp(const Algebra& u, const Algebra& v) {
        const Real s = u.w.squaredNorm();
        return dual_polynomial(u, v, cosc(s), cosc_ds(s), sincc(s), sincc_ds(s));
    }

    static Algebra dexpinv(const Algebra& u, const Algebra& v) {
        const Real s = u.w.squaredNorm();
        return dual_polynomial(u, v, -Real(1) / 2, 0, cotc(s), cotc_ds(s));
    }
    /// The value of a covector is the dual part of the product (f + eps m).(w + eps p), so that transposes are those of
    /// SO(3) over the dual numbers, on f + eps m.
    static Algebra dexpinv_transpose(const Algebra& u, const Algebra& c) {
        const Algebra dual = dexpinv({-u.p, -u.w}, {c.w, c.p});
        return {dual.w, dual.p};
    }

    /// cay(u) = (I - u/2)^{-1} (I + u/2) with the 4x4 matrix u: translation (I - hat(w)/2)^{-1} p.
    static Element cay(const Algebra& u) { return {cay_translation(u), SO3::cay(u.w)}; }
    static Vec3 cay_translation(const Algebra& u) {
        const Real a = 1 / (1 + u.w.squaredNorm() / 4);
        return a * (u.p + u.w.cross(u.p) / 2 + u.w.dot(u.p) / 4 * u.w);
    }

    /// (I - u/2) v (I + u/2) with the 4x4 matrices u, v; for v = (b, a):
    /// a - 1/2 w x a + 1/4 (w.a) w and b - 1/2 (w x b - a x p) - 1/4 w x (a x p).
    static Algebra dcayinv(const Algebra& u, const Algebra& v) {
        const Vec3 ap = v.w.cross(u.p);
        return {v.p - (u.w.cross(v.p) - ap) / 2 - u.w.cross(ap) / 4, SO3::dcayinv(u.w, v.w)};
    }
    /// F = f + 1/2 w x f and SO(3)'s m + 1/2 p x F.
    static Algebra dcayinv_transpose(const Algebra& u, const Algebra& c) {
        const Vec3 F = c.p + u.w.cross(c.p) / 2;
        return {F, SO3::dcayinv_transpose(u.w, c.w) + u.p.cross(F) / 2};
    }

    static Real orthogonality_defect(const Element& g) { return SO3::orthogonality_defect(g.R); }
    static Real squared_angle(const Algebra& u) { return u.w.squaredNorm(); }
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
