// SPDX-License-Identifier: BSD-3-Clause
//
// Bodies that hang by spherical joints, from the ground or from each other, without loops: the kinematics are those of
// Bodies, the solve is a recursion from the tips (articulated bodies [featherstone2008, Ch. 7], with a point in place
// of a body at each joint). In each body d leads from the joint to its parent to the mass centre, s_c to the joint with
// child c, and J is the inertia about the joint to the parent, all in body axes. Child c resists the acceleration a_c
// of its joint with the force M_c a_c + f_c. With X = R hat(d)^T, Z_c = R hat(s_c)^T, c_r = R (omega x (omega x r)),
// force F (space axes) and torque tau (body axes) from outside,
//   x'' = a + X omega' + c_d,   a_c = a + Z_c omega' + c_s,   D omega' = -B^T a - h,
//   D = J + sum Z_c^T M_c Z_c,   B = m X + sum M_c Z_c,
//   h = omega x J omega - tau - X^T F + sum Z_c^T (M_c c_s + f_c),
// and seen from the joint to the parent
//   M = m I + sum M_c - B D^{-1} B^T,   f = m c_d - F + sum (M_c c_s + f_c) - B D^{-1} h.
// M and f are in space axes, X and Z map from body to space: no vector is rotated from one body to the next. D is
// positive definite, so there is no singular position. A body without a parent is taken at its mass centre, where
// M a + f = 0. Where every body hangs on the ground by at most one joint and carries no load, D is constant, and each
// body is solved in registers.
#pragma once

#include "mechanics/formulations/bodies.hpp"
#include "mechanics/solve/forest.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

template <class Coordinates>
class SphericalBodies final : public Bodies<Coordinates> {
  public:
    /// Whether a model has only spherical joints and no loops.
    static bool fits(const Model& model);
    explicit SphericalBodies(Model model);

    Status accelerations(const Real& t, const Real* q, const Real* v, Real* dv, Real* lambda) override;
    Status solve_kkt(const Real& t, const Real* q, const Real* f, const Real* c, Real* a, Real* lambda) override;
    Status prepare_kkt(const Real& t, const Real* q) override;
    Status solve_prepared(const Real& t, const Real* q, const Real* f, const Real* c, Real* a, Real* lambda) override;

  private:
    using Base = Bodies<Coordinates>;
    using Factor = typename Coordinates::Factor;
    using Base::angular, Base::linear, Base::motion, Base::rotation;
    static constexpr int none = -1;

    /// A body, with the results of one evaluation. Parents come before their children.
    struct Node {
        int body = none;
        int joint = none;                  ///< to the parent or the ground; none for a free body
        int sign = 1;                      ///< of the multipliers: 1 where the body is the second of its joint
        int child = none, sibling = none;  ///< nodes: its first child, the next child of its parent
        bool rooted = true;                ///< has no parent body: hangs on the ground or is free
        Real mass = 1;
        Vec3 d = Vec3::Zero(), s = Vec3::Zero();  ///< s lies in the parent
        Mat3 J = Mat3::Identity();
        Mat3 M = Mat3::Zero(), G = Mat3::Zero();  ///< G = B D^{-1}
        Vec3 f = Vec3::Zero(), k = Vec3::Zero();  ///< k = D^{-1} h
        Vec3 c_d = Vec3::Zero(), c_s = Vec3::Zero();
        Vec3 a = Vec3::Zero();
    };
    /// What acts on a body: its angular velocity, the force in space axes and the torque in body axes.
    struct Action {
        Vec3 omega, force, torque;
    };
    /// The part of a node that depends only on the configuration, and what a right-hand side adds (omega = 0,
    /// so c_d = 0).
    struct Prepared {
        Mat3 X, Z, M, G, D_inverse;
        Vec3 f, k, c_s, a;
    };
    /// A body that hangs on the ground by one joint at r, or by none (then r and S^{-1} are zero).
    struct Anchored {
        int joint, sign;
        Real inverse_mass;
        Mat3 J, J_inverse, J_inverse_r, S_inverse;  ///< J_inverse_r = J^{-1} hat(r)
        Vec3 r;
    };

    void add_node(const Branch& branch);
    void find_anchored();
    Status forest_accelerations(const Real& t, const Real* q, const Real* v, Real* dv, Real* lambda);
    Status anchored_accelerations(const Real& t, const Real* q, const Real* v, Real* dv) const;
    Status anchored_solve(const Real* q, const Real* f, const Real* c, Real* a, Real* lambda) const;
    Status forest_solve(const Real* q, const Real* f, const Real* c, Real* a, Real* lambda);
    void add_wrenches(const Real& t, const Real* q, const Real* v);

    /// From the tips: M, f, G, k of all nodes. `act(node)` is an Action.
    template <class Act>
    void inwards(const Real* q, Act act);
    /// Back: calls put(node, R, x'', omega').
    template <class Put>
    void outwards(const Real* q, Put put);
    void report_multipliers(Real* lambda) const;

    std::vector<Node> nodes_;
    std::vector<Prepared> prepared_;  // of the nodes
    std::vector<Wrench> wrenches_;    // by body, in space and body axes
    std::vector<Anchored> anchored_;  // all bodies, or empty
    bool forces_;                     // whether anything but gravity acts
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
