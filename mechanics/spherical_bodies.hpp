// SPDX-License-Identifier: BSD-3-Clause
//
// Bodies with spherical joints alone: the kinematics are those of Bodies, the solves use what such joints have.
// Everything is solved in body axes: per body A = R^T x'' and omega', per joint the force mu = R_second^T lambda on
// the second body. The linear algebra of one evaluation is
//   free motion      A = R^T f/m,  omega' = J^{-1} (torque - omega x J omega)      (gravity and other forces)
//   joint residual   rho = E (A + omega' x r + omega x (omega x r))_first - (the same)_second
//   complement       S mu = rho
//   reaction         A -+ E^T mu / m,  omega' -+ J^{-1} (r x E^T mu)      (- first, + second)
// with E = R_second^T R_first for the first body and the identity for the second. Where every body hangs on the ground
// by at most one joint and carries no load, S is block diagonal and each body is solved on its own, in registers.
#pragma once

#include "mechanics/bodies.hpp"
#include "mechanics/schur.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

template <class Coordinates>
class SphericalBodies final : public Bodies<Coordinates> {
  public:
    /// Whether a model has spherical joints alone, with a moving second body each.
    static bool fits(const Model& model);
    explicit SphericalBodies(Model model);

    Status accelerations(const Real& t, const Real* q, const Real* v, Real* dv, Real* lambda) override;
    Status solve_kkt(const Real& t, const Real* q, const Real* f, const Real* c, Real* a, Real* lambda) override;
    void position_residual(const Real& t, const Real* q, Real* phi) const override;
    void velocity_residual(const Real& t, const Real* q, const Real* v, Real* residual) const override;
    std::string singularity() const override { return complement_.singularity(this->model()); }

  private:
    using Base = Bodies<Coordinates>;
    using Factor = typename Coordinates::Factor;
    using Base::angular, Base::linear, Base::motion, Base::position, Base::rotation;

    /// A body with what one evaluation computes for it: A = R^T x'' and omega'.
    struct Node {
        Real inverse_mass;
        Mat3 J, J_inverse;
        Mat3 R = Mat3::Identity();
        Vec3 omega = Vec3::Zero(), A = Vec3::Zero(), dw = Vec3::Zero();
        /// Body-axis acceleration of a point fixed in the body.
        Vec3 point_acceleration(const Vec3& r) const { return A + dw.cross(r) + omega.cross(omega.cross(r)); }
        void push(const Wrench& wrench) {
            A += inverse_mass * wrench.force;
            dw += J_inverse * wrench.torque;
        }
        /// A force at r, both in body axes.
        void apply(const Vec3& force, const Vec3& r) {
            A += inverse_mass * force;
            dw += J_inverse * r.cross(force);
        }
    };
    /// A joint with pointers to its bodies; `first` is null for the ground.
    struct Link {
        Node* first;
        Node* second;
        Vec3 r_first, r_second;
    };
    /// A body that hangs on the ground by one joint at r, or by none (then r and S^{-1} are zero).
    struct Anchored {
        Real inverse_mass;
        Mat3 J, J_inverse, J_inverse_r, S_inverse;  ///< J_inverse_r = J^{-1} hat(r)
        Vec3 r;
    };

    /// Relative rotations and the factors of the complement at the poses of the nodes.
    Status prepare_joints() { return complement_.is_constant() ? complement_.status() : refactor(); }
    Status refactor();
    void find_anchored();
    Status anchored_accelerations(const Real& t, const Real* q, const Real* v, Real* dv) const;
    /// Solves for the joint forces (on entry mu_ holds the residual) and applies them to the bodies.
    void apply_reactions();
    void report_multipliers(Real* lambda) const;

    SchurComplement complement_;
    std::vector<Node> nodes_;
    std::vector<Link> links_;
    std::vector<Mat3> relative_;
    std::vector<Vec3> mu_;
    std::vector<Anchored> anchored_;  // all bodies, or empty
    bool forces_;                     // whether anything but gravity acts
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
