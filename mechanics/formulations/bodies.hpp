// SPDX-License-Identifier: BSD-3-Clause
//
// Bodies of six degrees of freedom each, in the coordinates of a formulation, with joints as constraints: all of the
// system but its solves, which derived classes organise by the structure of the model. Rows of C are those of the
// joints (mechanics/joints/joint_rows.hpp) in the order of the model; rows without a position level come after all
// others.
#pragma once

#include "lie/power.hpp"
#include "mechanics/forces/forces.hpp"
#include "mechanics/formulations/coordinates.hpp"
#include "mechanics/joints/joint_rows.hpp"
#include "mechanics/space_axes.hpp"
#include "mechanics/system.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

template <class Coordinates>
class Bodies : public System, public SpaceAxes {
  public:
    explicit Bodies(Model model);

    int constraints() const override { return rows_; }
    int position_constraints() const override { return position_rows_; }
    int mass_block() const override { return 6; }
    void mass(const Real* q, Real* blocks) const override;
    void solve_mass(const Real* q, const Real* f, Real* a) const override;
    void applied_force(const Real& t, const Real* q, const Real* v, Real* f) const override;
    void gyroscopic_force(const Real* q, const Real* v, Real* f) const override;
    void position_residual(const Real& t, const Real* q, Real* phi) const override;
    void jacobian(const Real& t, const Real* q, Real* C) const override;
    void apply_jacobian(const Real& t, const Real* q, const Real* v, Real* product) const override;
    void apply_jacobian_transpose(const Real& t, const Real* q, const Real* lambda, Real* f) const override;
    void complement_diagonal(const Real& t, const Real* q, Real* diagonal) const override;
    void velocity_bias(const Real& t, const Real* q, Real* b) const override;
    void velocity_residual(const Real& t, const Real* q, const Real* v, Real* residual) const override;
    void acceleration_bias(const Real& t, const Real* q, const Real* v, Real* xi) const override;
    bool has_ambient_jacobian() const override;
    void ambient_jacobian(const Real& t, const Real* q, const Real* v, Real* G) const override;
    void row_scale(Real* scale) const override;
    void position_scale(const Real* q, Real* size) const override;
    std::vector<ConstraintRow> constraint_rows() const override { return kreisel::constraint_rows(model_); }
    Status reactions(const Real& t, const Real* q, const Real* v, const Real* lambda, JointReaction* out) override;
    bool has_potential() const override { return is_conservative(model_); }
    Real potential(const Real& t, const Real* q) const override;

    int bodies() const override { return static_cast<int>(model_.bodies.size()); }
    void read(const Real* y, BodyState* states) const override;
    void write(const BodyState* states, Real* y) const override;

    std::string reason(Status status) const override { return status == Status::turn_lost ? turns_.reason() : ""; }
    Status begin_step(const Real& t, const Real& h, const Real* y) override;
    Status end_step(Status result, const Real& t, Real* y) override;
    void read_angles(const Real* q, SpringAngle* angles) const override;

    void to_space_axes(const Real* q, const Real* v, Real* turned) const override;
    void from_space_axes(const Real* q, const Real* turned, Real* v) const override;

  protected:
    using Factor = typename Coordinates::Factor;

    static const Real* pose(const Real* q, int body) { return q + body * Factor::size; }
    static auto rotation(const Real* q, int body) { return Coordinates::Rotations::rotation(pose(q, body) + 3); }
    static Vec3 position(const Real* q, int body) { return vec3(pose(q, body)); }
    static Vec3 linear(const Real* v, int body) { return vec3(v + body * 6); }
    static Vec3 angular(const Real* v, int body) { return vec3(v + body * 6 + 3); }
    /// Of a body or of the ground; without v, at rest.
    static Motion motion(const Real* q, const Real* v, int body);
    const Model& model() const { return model_; }
    const Turns& turns() const { return turns_; }
    /// Where row k of a joint stands among the rows of C.
    int row(std::size_t joint, int k) const {
        const auto& [all, position, first, first_velocity] = places_[joint];
        return k < position ? first + k : first_velocity + k - position;
    }

  private:
    struct Place {
        int all, position;          // rows of the joint
        int first, first_velocity;  // where its position rows and its others begin
    };
    /// Calls f(joint, its rows) for all joints.
    template <class F>
    void each_joint(const Real& t, const Real* q, const Real* v, F f) const;

    void point_positions(const Real* q, Real* phi) const;
    void point_velocities(const Real* q, const Real* v, Real* residual) const;
    /// C v + share b.
    void row_velocities(const Real& t, const Real* q, const Real* v, int share, Real* residual) const;

    Model model_;
    std::vector<Mat3> J_inverse_;
    Turns turns_;
    bool spherical_;  // only spherical joints: then the residuals are those of points, for any 3x3 matrices R
    std::vector<Place> places_;
    int rows_ = 0, position_rows_ = 0;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
