// SPDX-License-Identifier: BSD-3-Clause
//
// Bodies that hang on the ground by at most one spherical joint each, without loads and springs: nothing links them,
// and each is solved in registers. With the joint at r from the mass centre (body axes; r and S^{-1} are zero for a
// free body) and A = R^T x'',
//   A = R^T g - mu / m,   omega' = J^{-1} (J omega x omega) - J^{-1} hat(r) mu,
//   S mu = R^T g + omega'_free x r + omega x (omega x r),   S = I / m - hat(r) J^{-1} hat(r),
// where -mu is the joint's force in body axes: its point does not move.
#pragma once

#include <Eigen/LU>
#include <vector>

#include "lie/status.hpp"
#include "mechanics/formulations/body_layout.hpp"
#include "mechanics/solve/articulated_tree.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

template <class Coordinates>
class AnchoredBodies {
  public:
    explicit AnchoredBodies(const Model& model) {
        bodies_.resize(model.bodies.size());
        for (const TreeNode& node : articulated_tree(model))
            bodies_[static_cast<std::size_t>(node.body)] = anchored(node, model);
    }

    /// v' at (q, v) in the gravity of time t.
    Status accelerations(const Gravity& gravity, const Real& t, const Real* q, const Real* v, Real* dv) const;
    /// [M C^T; C 0] [a; lambda] = [f; c]; lambda may be null, and so may f, which is then zero.
    Status solve(const Real* q, const Real* f, const Real* c, Real* a, Real* lambda) const {
        return f ? solve<true>(q, f, c, a, lambda) : solve<false>(q, f, c, a, lambda);
    }

  private:
    template <bool forces>
    Status solve(const Real* q, const Real* f, const Real* c, Real* a, Real* lambda) const;

    static constexpr int none = TreeNode::none;
    struct Anchored {
        int joint, sign;
        Real inverse_mass;
        Mat3 J, J_inverse, J_inverse_r, S_inverse;  // J_inverse_r = J^{-1} hat(r)
        Vec3 r;
    };
    static Anchored anchored(const TreeNode& node, const Model& model) {
        const Body& body = model.bodies[static_cast<std::size_t>(node.body)];
        const Vec3 r = -node.d;
        const Mat3 J_inverse = body.J.inverse(), J_inverse_r = J_inverse * hat(r);
        const Mat3 S = inverse_mass(body) * Mat3::Identity() - hat(r) * J_inverse_r;
        const Mat3 S_inverse = node.joint == none ? Mat3(Mat3::Zero()) : Mat3(S.inverse());
        return {node.joint, node.sign, inverse_mass(body), body.J, J_inverse, J_inverse_r, S_inverse, r};
    }

    std::vector<Anchored> bodies_;
};

template <class Coordinates>
KREISEL_HOT Status AnchoredBodies<Coordinates>::accelerations(const Gravity& gravity, const Real& t, const Real* q,
                                                              const Real* v, Real* dv) const {
    Vec3 modulated;
    const Vec3& g = gravity.is_constant() ? gravity.g : (modulated = gravity.at(t));
    Real sum = 0;
    for (const Anchored& body : bodies_) {
        const auto R = Coordinates::Rotations::rotation(q + 3);
        const Vec3 w = vec3(v + 3), r = body.r, Jw = body.J * w;
        Vec3 A = R.transpose() * g;
        Vec3 dw = body.J_inverse * Jw.cross(w);
        const Vec3 mu = body.S_inverse * (A + dw.cross(r) + w.cross(w.cross(r)));
        A -= body.inverse_mass * mu;
        dw -= body.J_inverse_r * mu;
        const Vec3 a = Coordinates::rate(Coordinates::from_body(R, A), w, vec3(v));
        sum += (a[0] + a[1] + a[2]) + (dw[0] + dw[1] + dw[2]);
        store(a, dv), store(dw, dv + 3);
        q += BodyLayout<Coordinates>::pose_size, v += 6, dv += 6;
    }
    return isfinite(sum) ? Status::ok : Status::non_finite;
}

template <class Coordinates>
template <bool forces>
KREISEL_HOT Status AnchoredBodies<Coordinates>::solve(const Real* q, const Real* f, const Real* c, Real* a,
                                                      Real* lambda) const {
    Real sum = 0;
    for (const Anchored& body : bodies_) {
        const auto R = Coordinates::Rotations::rotation(q + 3);
        Vec3 A = Vec3::Zero(), dw = Vec3::Zero();
        if constexpr (forces) {
            A = body.inverse_mass * Coordinates::to_body(R, vec3(f)), dw = body.J_inverse * vec3(f + 3);
            f += 6;
        }
        if (body.joint != none) {  // the rows demand the acceleration of the first body's point less the second's
            const Vec3 demanded = body.sign * (R.transpose() * vec3(c + 3 * body.joint));
            const Vec3 mu = body.S_inverse * (forces ? Vec3(A + dw.cross(body.r) + demanded) : demanded);
            A -= body.inverse_mass * mu;
            dw -= body.J_inverse_r * mu;
            if (lambda) store(Vec3(-body.sign * (R * mu)), lambda + 3 * body.joint);
        }
        const Vec3 out = Coordinates::from_body(R, A);
        sum += (out[0] + out[1] + out[2]) + (dw[0] + dw[1] + dw[2]);
        store(out, a), store(dw, a + 3);
        q += BodyLayout<Coordinates>::pose_size, a += 6;
    }
    return isfinite(sum) ? Status::ok : Status::non_finite;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
