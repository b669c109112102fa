// SPDX-License-Identifier: BSD-3-Clause
//
// The KKT system of a forest of spherical joints for given right-hand sides: the recursion of
// mechanics/formulations/articulated_accelerations.hpp with omega = 0, in two parts. What depends on the configuration
// only is prepared once; each right-hand side then takes an inward and an outward pass.
#pragma once

#include "mechanics/formulations/articulated_accelerations.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

template <class Coordinates>
class ArticulatedSolve {
    using Layout = BodyLayout<Coordinates>;

  public:
    /// The bodies outlive this.
    explicit ArticulatedSolve(const std::vector<ArticulatedBody>& bodies) : bodies_(bodies), nodes_(bodies.size()) {}

    /// From the tips: X, Z, M, G, D^{-1} of all bodies.
    KREISEL_HOT void prepare(const Real* q) {
        for (std::size_t i = nodes_.size(); i-- > 0;) {
            const ArticulatedBody& body = bodies_[i];
            Node& node = nodes_[i];
            const auto R = Layout::rotation(q, body.body);
            node.X = arm(R, body.d);
            ArticulatedInertia inertia(body.J, body.mass, node.X);
            for (int c = body.child; c != none; c = next(c)) {
                Node& child = at(c);
                child.Z = arm(R, bodies_[static_cast<std::size_t>(c)].s);
                inertia.add_child(child.M, child.Z);
            }
            const SymmetricInverse inverse(inertia.D);
            const Mat3 H = inertia.B * inverse.adjugate;
            inertia.reduce(H, inverse.factor);
            node.M = inertia.M, node.G = inverse.factor * H, node.D_inverse = inverse.factor * inverse.adjugate;
        }
    }

    /// [M C^T; C 0] [a; lambda] = [f; c] at the q that was prepared; lambda may be null, and so may f, which is then
    /// zero.
    KREISEL_HOT Status solve(const Real* q, const Real* f, const Real* c, Real* a, Real* lambda) {
        inward_pass(q, f, c);
        return outward_pass(q, a, lambda);
    }

  private:
    static constexpr int none = TreeNode::none;
    /// Of a body: what is prepared, and what a right-hand side adds.
    struct Node {
        Mat3 X, Z, M, G, D_inverse;
        Vec3 f, k, c_s, a;
    };
    Node& at(int node) { return nodes_[static_cast<std::size_t>(node)]; }
    int next(int child) const { return bodies_[static_cast<std::size_t>(child)].sibling; }

    /// From the tips: f and k of all bodies.
    void inward_pass(const Real* q, const Real* f, const Real* c) {
        for (std::size_t i = nodes_.size(); i-- > 0;) {
            const ArticulatedBody& body = bodies_[i];
            Node& node = nodes_[i];
            Vec3 h = Vec3::Zero(), force = Vec3::Zero();
            if (f) {
                const Vec3 F = Coordinates::to_space(Layout::rotation(q, body.body), vec3(f + 6 * body.body));
                h = -vec3(f + 6 * body.body + 3) - node.X.transpose() * F, force = -F;
            }
            for (int k = body.child; k != none; k = next(k)) {
                const Node& child = at(k);
                const Vec3 pull = child.M * child.c_s + child.f;
                h += child.Z.transpose() * pull, force += pull;
            }
            // The rows demand the acceleration of the first body's point less the second's.
            node.c_s.setZero();
            if (body.joint != none) node.c_s = -body.sign * vec3(c + 3 * body.joint);
            node.f = force - node.G * h, node.k = node.D_inverse * h;
        }
    }

    /// Back to the tips: a and lambda.
    Status outward_pass(const Real* q, Real* a, Real* lambda) {
        Real sum = 0;
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            const ArticulatedBody& body = bodies_[i];
            Node& node = nodes_[i];
            if (body.rooted) node.a = body.joint == none ? free_acceleration(node.M, node.f) : node.c_s;
            const Vec3 dw = -(node.G.transpose() * node.a) - node.k;
            for (int k = body.child; k != none; k = next(k)) {
                Node& child = at(k);
                child.a = node.a + child.Z * dw + child.c_s;
            }
            const Vec3 out = Coordinates::from_space(Layout::rotation(q, body.body), Vec3(node.a + node.X * dw));
            sum += out.sum() + dw.sum();
            store(out, a + 6 * body.body), store(dw, a + 6 * body.body + 3);
            if (lambda && body.joint != none)
                store(Vec3(body.sign * (node.M * node.a + node.f)), lambda + 3 * body.joint);
        }
        return isfinite(sum) ? Status::ok : Status::non_finite;
    }

    const std::vector<ArticulatedBody>& bodies_;
    std::vector<Node> nodes_;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
