// SPDX-License-Identifier: BSD-3-Clause
//
// Bodies of six degrees of freedom each, with spherical joints as constraints, in the coordinates of a formulation.
// Everything is solved in body axes: per body A = R^T x'' and omega', per joint the force mu = R_second^T lambda on
// the second body. The linear algebra of one evaluation is
//   free motion      A = R^T f/m,  omega' = J^{-1} (torque - omega x J omega)      (gravity and loads)
//   joint residual   rho = E (A + omega' x r + omega x (omega x r))_first - (the same)_second
//   complement       S mu = rho
//   reaction         A -+ E^T mu / m,  omega' -+ J^{-1} (r x E^T mu)      (- first, + second)
// with E = R_second^T R_first for the first body and the identity for the second. Where every body hangs on the ground
// by at most one joint and carries no load, S is block diagonal and each body is solved on its own, in registers.
#pragma once

#include <cstddef>
#include <memory>

#include "lie/power.hpp"
#include "mechanics/coordinates.hpp"
#include "mechanics/schur.hpp"
#include "mechanics/system.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

template <class Coordinates>
class FreeBodies final : public System {
  public:
    explicit FreeBodies(Model model);

    int constraints() const override { return 3 * static_cast<int>(model_.joints.size()); }
    Status accelerations(const Real& t, const Real* q, const Real* v, Real* dv, Real* lambda) override;
    Status solve_kkt(const Real& t, const Real* q, const Real* f, const Real* c, Real* a, Real* lambda) override;

    int mass_block() const override { return 6; }
    void mass(const Real* q, Real* blocks) const override;
    void applied_force(const Real& t, const Real* q, const Real* v, Real* f) const override;
    void gyroscopic_force(const Real* q, const Real* v, Real* f) const override;
    void position_residual(const Real& t, const Real* q, Real* phi) const override;
    void jacobian(const Real& t, const Real* q, Real* C) const override;
    void velocity_residual(const Real& t, const Real* q, const Real* v, Real* residual) const override;
    bool ambient_jacobian(const Real& t, const Real* q, const Real* v, Real* G) const override;
    void acceleration_bias(const Real& t, const Real* q, const Real* v, Real* xi) const override;
    void row_scale(Real* scale) const override;
    bool has_potential() const override { return model_.gravity.is_constant() && model_.loads.empty(); }
    Real potential(const Real& t, const Real* q) const override;

    int bodies() const override { return static_cast<int>(model_.bodies.size()); }
    void read(const Real* y, BodyState* states) const override;
    void write(const BodyState* states, Real* y) const override;

  private:
    using Factor = typename Coordinates::Factor;
    /// A body with what one evaluation computes for it: A = R^T x'' and omega'.
    struct Node {
        Real inverse_mass;
        Mat3 J, J_inverse;
        Vec3 A = Vec3::Zero(), dw = Vec3::Zero();
        /// Body-axis acceleration of a point fixed in the body, turning with angular velocity w.
        Vec3 point_acceleration(const Vec3& r, const Vec3& w) const { return A + dw.cross(r) + w.cross(w.cross(r)); }
        Vec3 point_acceleration(const Vec3& r) const { return A + dw.cross(r); }
        /// A force through the mass centre and a torque, in body axes.
        void push(const Load::Wrench& load) {
            A += inverse_mass * load.force;
            dw += J_inverse * load.torque;
        }
        /// A force at r, both in body axes.
        void apply(const Vec3& force, const Vec3& r) {
            A += inverse_mass * force;
            dw += J_inverse * r.cross(force);
        }
    };
    /// A joint with pointers to its bodies and the offsets of their states; `first` is null for the ground.
    struct Link {
        Node* first;
        Node* second;
        std::ptrdiff_t first_R, second_R, first_omega, second_omega;
        Vec3 r_first, r_second;
    };

    /// A body that hangs on the ground by one joint at r, or by none (then r and S^{-1} are zero).
    struct Anchored {
        Real inverse_mass;
        Mat3 J, J_inverse, J_inverse_r, S_inverse;  ///< J_inverse_r = J^{-1} hat(r)
        Vec3 r;
    };

    static Rotation rotation(const Real* q, int body) { return mat3(q + body * Factor::size + 3); }
    static Vec3 position(const Real* q, int body) { return vec3(q + body * Factor::size); }
    static Vec3 linear(const Real* v, int body) { return vec3(v + body * 6); }
    static Vec3 angular(const Real* v, int body) { return vec3(v + body * 6 + 3); }
    /// Space coordinates of a joint's point on a body or on the ground.
    static Vec3 point(const Real* q, int body, const Vec3& r) {
        return body == ground ? r : Vec3(position(q, body) + rotation(q, body) * r);
    }
    /// Relative rotations and the factors of the complement at q.
    Status prepare_joints(const Real* q) { return complement_.is_constant() ? complement_.status() : refactor(q); }
    Status refactor(const Real* q);
    void find_anchored();
    Status anchored_accelerations(const Real& t, const Real* q, const Real* v, Real* dv) const;
    /// Solves for the joint forces (on entry mu_ holds the residual) and applies them to the bodies.
    void apply_reactions();
    void report_multipliers(const Real* q, Real* lambda) const;

    Model model_;
    SchurComplement complement_;
    std::vector<Node> nodes_;
    std::vector<Link> links_;
    std::vector<Mat3> relative_;
    std::vector<Vec3> mu_;
    std::vector<Anchored> anchored_;  // all bodies, or empty
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
