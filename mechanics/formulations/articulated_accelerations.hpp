// SPDX-License-Identifier: BSD-3-Clause
//
// Accelerations of a forest of spherical joints under given forces: the inward and the outward pass of the articulated-
// body algorithm [featherstone2008, Ch. 7]. Symbols and equations are those of
// mechanics/formulations/spherical_bodies.hpp.
#pragma once

#include "mechanics/formulations/body_layout.hpp"
#include "mechanics/solve/articulated_inertia.hpp"
#include "mechanics/solve/articulated_tree.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// A node with the results of one evaluation.
struct ArticulatedBody : TreeNode {
    Mat3 M = Mat3::Zero(), G = Mat3::Zero();  ///< G = B D^{-1}
    Vec3 f = Vec3::Zero(), k = Vec3::Zero();  ///< k = D^{-1} h
    Vec3 c_d = Vec3::Zero(), c_s = Vec3::Zero();
    Vec3 a = Vec3::Zero();  ///< of the joint to the parent
};

/// What acts on a body: its angular velocity, the force in space axes and the torque in body axes.
struct Action {
    Vec3 omega, force, torque;
};

template <class Coordinates>
class ArticulatedAccelerations {
    using Layout = BodyLayout<Coordinates>;

  public:
    explicit ArticulatedAccelerations(const Model& model) {
        for (const TreeNode& node : articulated_tree(model)) bodies_.push_back({node});
    }
    const std::vector<ArticulatedBody>& bodies() const { return bodies_; }

    /// Both passes. `act(body)` is the Action on a body; put(body, R, x'', omega') takes what comes of it.
    template <class Act, class Put>
    void evaluate(const Real* q, Act act, Put put) {
        for (ArticulatedBody& body : bodies_)
            if (body.rooted) body.c_s.setZero();  // the ground does not move
        inward_pass(q, act);
        outward_pass(q, put);
    }
    /// Of the last evaluation.
    void multipliers(Real* lambda) const {
        for (const ArticulatedBody& body : bodies_)
            if (body.joint != none) store(Vec3(body.sign * (body.M * body.a + body.f)), lambda + 3 * body.joint);
    }

  private:
    static constexpr int none = TreeNode::none;
    ArticulatedBody& at(int node) { return bodies_[static_cast<std::size_t>(node)]; }

    /// From the tips: M, f, G, k of all bodies.
    template <class Act>
    void inward_pass(const Real* q, Act act) {
        for (auto body = bodies_.rbegin(); body != bodies_.rend(); ++body) {
            const auto R = Layout::rotation(q, body->body);
            const Action action = act(*body);
            const Mat3 X = arm(R, body->d);
            body->c_d = centripetal(R, action.omega, body->d);
            ArticulatedInertia inertia(body->J, body->mass, X);
            Vec3 h = action.omega.cross(body->J * action.omega) - action.torque - X.transpose() * action.force;
            Vec3 f = body->mass * body->c_d - action.force;
            for (int c = body->child; c != none; c = at(c).sibling) {
                ArticulatedBody& child = at(c);
                child.c_s = centripetal(R, action.omega, child.s);
                const Mat3 Z = arm(R, child.s);
                const Vec3 force = child.M * child.c_s + child.f;
                inertia.add_child(child.M, Z);
                h += Z.transpose() * force, f += force;
            }
            const SymmetricInverse inverse(inertia.D);
            const Mat3 H = inertia.B * inverse.adjugate;
            inertia.reduce(H, inverse.factor);
            body->M = inertia.M, body->f = f - inverse.factor * (H * h);
            body->G = inverse.factor * H, body->k = inverse.factor * (inverse.adjugate * h);
        }
    }

    /// Back to the tips: accelerations.
    template <class Put>
    void outward_pass(const Real* q, Put put) {
        for (ArticulatedBody& body : bodies_) {
            if (body.rooted) body.a = body.joint == none ? free_acceleration(body.M, body.f) : body.c_s;
            const auto R = Layout::rotation(q, body.body);
            const Vec3 dw = -(body.G.transpose() * body.a) - body.k;
            for (int c = body.child; c != none; c = at(c).sibling) {
                ArticulatedBody& child = at(c);
                child.a = body.a + R * dw.cross(child.s) + child.c_s;
            }
            put(body, R, Vec3(body.a + R * dw.cross(body.d) + body.c_d), dw);
        }
    }

    std::vector<ArticulatedBody> bodies_;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
