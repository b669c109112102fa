// SPDX-License-Identifier: BSD-3-Clause
//
// Forward dynamics of a chain of N equal links on spherical joints, written by hand as a measure for the general code:
// no joint graph, no virtual call, one sweep from the tip to the ground and one back. Links have their joints at -l e
// and l e, e the first body axis, and the inertia diag(Jx, Jy, Jz). A force on the axis has no moment about it, so a
// link has two unknowns instead of three: omega' x e = u_1 b_1 + u_2 b_2, where b_1, b_2 are the second and third body
// axes.
//
// All that hangs on the lower end of a link resists its acceleration a+ with the force M a+ + f. With
// c = omega x (omega x l e) and a- the acceleration of the upper end, x'' = a- + l u + c, a+ = a- + 2 l u + 2 c, and
// the moments about the upper end give
//   D u = -B^T a- - p,   B_i = l (m b_i + 2 M b_i),   D = diag(Jz, Jy) + l^2 (m I + 4 b_i . M b_k),
//   p_i = l b_i . (m (c - g) + 4 M c + 2 f) + ((Jy - Jx) omega_x omega_y, (Jz - Jx) omega_x omega_z).
// Seen from the upper end, M <- m I + M - B D^{-1} B^T, f <- m (c - g) + 2 M c + f - B D^{-1} p. In space axes nothing
// is rotated from link to link.
#pragma once

#include <vector>

#include "mechanics/model/model.hpp"

namespace bench {

using namespace kreisel;

class ChainKernel {
  public:
    /// Of the problem `chain`.
    explicit ChainKernel(const Model& model)
        : links_(model.bodies.size()),
          J_(model.bodies[0].J.diagonal()),
          g_(model.gravity.g),
          m_(model.bodies[0].mass),
          l_(-model.joints[0].r_second[0]) {}

    /// v' in the coordinates of SO3xR3: q = (x, R), v = (x', omega), v' = (x'', omega') of each link.
    void evaluate(const Real* q, const Real* v, Real* dv) {
        inwards(q, v);
        outwards(q, v, dv);
    }

  private:
    /// Used by the sweep back: u = -G a- - k.
    struct Link {
        Vec3 c, G1, G2;
        Real k1, k2;
    };
    static constexpr int pose_size = 12, velocity_size = 6;

    KREISEL_HOT void inwards(const Real* q, const Real* v) {
        Real xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;  // M
        Vec3 f = Vec3::Zero();
        const Real D1 = J_[2] + m_ * l_ * l_, D2 = J_[1] + m_ * l_ * l_, four = 4 * l_ * l_;
        const Real gyro1 = J_[1] - J_[0], gyro2 = J_[2] - J_[0];
        const auto M = [&](const Vec3& a) {
            return Vec3(xx * a[0] + xy * a[1] + xz * a[2], xy * a[0] + yy * a[1] + yz * a[2],
                        xz * a[0] + yz * a[1] + zz * a[2]);
        };
        for (std::size_t i = links_.size(); i-- > 0;) {
            Link& link = links_[i];
            const Real* R = q + pose_size * i + 3;
            const Real* w = v + velocity_size * i + 3;
            const Vec3 e = vec3(R), b1 = vec3(R + 3), b2 = vec3(R + 6);
            const Real wxy = w[0] * w[1], wxz = w[0] * w[2];
            link.c = l_ * (wxy * b1 + wxz * b2 - (w[1] * w[1] + w[2] * w[2]) * e);
            const Vec3 Mb1 = M(b1), Mb2 = M(b2), Mc = M(link.c), weight = m_ * (link.c - g_);
            const Vec3 B1 = l_ * (m_ * b1 + 2 * Mb1), B2 = l_ * (m_ * b2 + 2 * Mb2),
                       load = l_ * (weight + 4 * Mc + 2 * f);
            const Real d11 = D1 + four * b1.dot(Mb1), d22 = D2 + four * b2.dot(Mb2), d12 = four * b1.dot(Mb2);
            const Real p1 = b1.dot(load) + gyro1 * wxy, p2 = b2.dot(load) + gyro2 * wxz;
            // B adj(D) does not depend on the division, which is on the critical path of the next link.
            const Real inverse = 1 / (d11 * d22 - d12 * d12);
            const Vec3 H1 = d22 * B1 - d12 * B2, H2 = d11 * B2 - d12 * B1;
            xx += m_ - inverse * (B1[0] * H1[0] + B2[0] * H2[0]);
            yy += m_ - inverse * (B1[1] * H1[1] + B2[1] * H2[1]);
            zz += m_ - inverse * (B1[2] * H1[2] + B2[2] * H2[2]);
            xy -= inverse * (B1[0] * H1[1] + B2[0] * H2[1]);
            xz -= inverse * (B1[0] * H1[2] + B2[0] * H2[2]);
            yz -= inverse * (B1[1] * H1[2] + B2[1] * H2[2]);
            link.G1 = inverse * H1, link.G2 = inverse * H2;
            link.k1 = inverse * (d22 * p1 - d12 * p2), link.k2 = inverse * (d11 * p2 - d12 * p1);
            f += weight + 2 * Mc - link.k1 * B1 - link.k2 * B2;
        }
    }

    KREISEL_HOT void outwards(const Real* q, const Real* v, Real* dv) const {
        Vec3 a = Vec3::Zero();  // of the upper end
        const Real gyro = (J_[1] - J_[2]) / J_[0];
        for (const Link& link : links_) {
            const Vec3 b1 = vec3(q + 6), b2 = vec3(q + 9);
            const Real u1 = -link.G1.dot(a) - link.k1, u2 = -link.G2.dot(a) - link.k2;
            const Vec3 half = l_ * (u1 * b1 + u2 * b2) + link.c;
            store(Vec3(a + half), dv);
            dv[3] = gyro * v[4] * v[5], dv[4] = -u2, dv[5] = u1;
            a += 2 * half;
            q += pose_size, v += velocity_size, dv += velocity_size;
        }
    }

    std::vector<Link> links_;
    Vec3 J_, g_;
    Real m_, l_;
};

}  // namespace bench
