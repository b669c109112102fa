// SPDX-License-Identifier: BSD-3-Clause
//
// Forward dynamics of any chain on spherical joints by recursion from its tip (articulated bodies [featherstone2008, Ch. 7],
// a point instead of a body at each joint): what chain_kernel.hpp costs without its knowledge of equal, slender links.
//
// In each link d leads from the upper joint to the mass centre, s to the lower joint; J is the inertia about the upper joint
// (all in body axes). All that hangs on the lower joint answers its acceleration a+ with the force M a+ + f. With
// X = R hat(d)^T, Z = R hat(s)^T and c_r = R (omega x (omega x r)), x'' = a- + X omega' + c_d, a+ = a- + Z omega' + c_s and
//   D omega' = -B^T a- - p,   D = J + Z^T M Z,   B = m X + M Z,   p = omega x J omega - m X^T g + Z^T (M c_s + f);
// from the upper joint, M <- m I + M - B D^{-1} B^T, f <- m (c_d - g) + M c_s + f - B D^{-1} p.
// M and f are in space axes and X, Z map body to space: no matrix is turned from one link to the next.
#pragma once

#include <vector>

#include "mechanics/model.hpp"

namespace bench {

using namespace kreisel;

class ChainRecursion {
  public:
    /// Bodies and joints in order from the ground on.
    explicit ChainRecursion(const Model& model) : g_(model.gravity.g) {
        const std::size_t n = model.bodies.size();
        for (std::size_t i = 0; i < n; ++i) {
            const Vec3 d = -model.joints[i].r_second;
            const Vec3 s = i + 1 < n ? Vec3(model.joints[i + 1].r_first + d) : Vec3(Vec3::Zero());
            links_.push_back({.mass = model.bodies[i].mass, .d = d, .s = s, .J = inertia_about(model.bodies[i], d)});
        }
    }

    /// As ChainKernel::evaluate.
    void evaluate(const Real* q, const Real* v, Real* dv) {
        inwards(q, v);
        outwards(q, dv);
    }

  private:
    struct Link {
        Real mass;
        Vec3 d, s;
        Mat3 J;
        Vec3 c_d = {}, c_s = {}, k = {};  ///< omega' = -G^T a- - k
        Mat3 G = {};
    };
    static constexpr int pose_size = 12, velocity_size = 6;

    /// R hat(r)^T: column k is R (e_k x r).
    static Mat3 arm(const auto& R, const Vec3& r) {
        Mat3 A;
        A << r[1] * R.col(2) - r[2] * R.col(1), r[2] * R.col(0) - r[0] * R.col(2), r[0] * R.col(1) - r[1] * R.col(0);
        return A;
    }

    KREISEL_HOT void inwards(const Real* q, const Real* v) {
        Mat3 M = Mat3::Zero();
        Vec3 f = Vec3::Zero();
        for (std::size_t i = links_.size(); i-- > 0;) {
            Link& link = links_[i];
            const auto R = mat3(q + pose_size * i + 3);
            const Vec3 w = vec3(v + velocity_size * i + 3);
            const Mat3 X = arm(R, link.d), Z = arm(R, link.s), Y = M * Z, B = link.mass * X + Y;
            link.c_d = R * w.cross(w.cross(link.d)), link.c_s = R * w.cross(w.cross(link.s));
            const Vec3 F = M * link.c_s + f, Jw = link.J * w;
            const Vec3 p = w.cross(Jw) - link.mass * (X.transpose() * g_) + Z.transpose() * F;
            const Real a = link.J(0, 0) + Z.col(0).dot(Y.col(0)), b = link.J(0, 1) + Z.col(0).dot(Y.col(1)),
                       c = link.J(0, 2) + Z.col(0).dot(Y.col(2)), d = link.J(1, 1) + Z.col(1).dot(Y.col(1)),
                       e = link.J(1, 2) + Z.col(1).dot(Y.col(2)), h = link.J(2, 2) + Z.col(2).dot(Y.col(2));
            // Cofactors of D; B adj(D) does not wait for the division.
            const Real A00 = d * h - e * e, A01 = c * e - b * h, A02 = b * e - c * d;
            const Real A11 = a * h - c * c, A12 = b * c - a * e, A22 = a * d - b * b;
            const Real inverse = 1 / (a * A00 + b * A01 + c * A02);
            Mat3 H;
            H << B.col(0) * A00 + B.col(1) * A01 + B.col(2) * A02, B.col(0) * A01 + B.col(1) * A11 + B.col(2) * A12,
                B.col(0) * A02 + B.col(1) * A12 + B.col(2) * A22;
            for (int j = 0; j < 3; ++j)
                for (int k = 0; k <= j; ++k) M(j, k) -= inverse * H.row(j).dot(B.row(k));
            M(0, 1) = M(1, 0), M(0, 2) = M(2, 0), M(1, 2) = M(2, 1);
            M.diagonal().array() += link.mass;
            link.G = inverse * H;
            link.k = inverse * Vec3(A00 * p[0] + A01 * p[1] + A02 * p[2], A01 * p[0] + A11 * p[1] + A12 * p[2],
                                    A02 * p[0] + A12 * p[1] + A22 * p[2]);
            f = link.mass * (link.c_d - g_) + F - link.G * p;
        }
    }

    KREISEL_HOT void outwards(const Real* q, Real* dv) const {
        Vec3 a = Vec3::Zero();
        for (const Link& link : links_) {
            const auto R = mat3(q + 3);
            const Vec3 dw = -(link.G.transpose() * a) - link.k;
            store(Vec3(a + R * dw.cross(link.d) + link.c_d), dv), store(dw, dv + 3);
            a += R * dw.cross(link.s) + link.c_s;
            q += pose_size, dv += velocity_size;
        }
    }

    std::vector<Link> links_;
    Vec3 g_;
};

}  // namespace bench
