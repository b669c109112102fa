// SPDX-License-Identifier: BSD-3-Clause
//
// Bodies that each turn about a fixed point: q = R, v = omega, no constraints. With the lever c from the point to
// the mass centre (body axes) and J_O = J + m (|c|^2 I - c c^T),
//   J_O omega' = c x (m R^T g + force) + torque - omega x J_O omega,   x = P + R c,   x' = R (omega x c),
// force and torque being those of loads and springs in body axes. The point exerts the force m (x'' - g) - R force.
#pragma once

#include <memory>
#include <optional>

#include "lie/power.hpp"
#include "lie/so3.hpp"
#include "mechanics/forces/forces.hpp"
#include "mechanics/model/symmetries.hpp"
#include "mechanics/space_axes.hpp"
#include "mechanics/system.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Those that join a body to another or to the ground.
std::vector<const Joint*> joints_of(const Model& model, int body);

/// For models in which each body hangs on the ground by at most one spherical joint, and one without is at rest.
class PivotedBodies final : public System, public SpaceAxes {
  public:
    explicit PivotedBodies(Model model);

    Status accelerations(const Real& t, const Real* q, const Real* v, Real* dv, Real* lambda) override;
    Status solve_kkt(const Real& t, const Real* q, const Real* f, const Real* c, Real* a, Real* lambda) override;
    Status reactions(const Real& t, const Real* q, const Real* v, const Real* lambda, JointReaction* out) override;
    int mass_block() const override { return 3; }
    void mass(const Real* q, Real* blocks) const override;
    void applied_force(const Real& t, const Real* q, const Real* v, Real* f) const override;
    void gyroscopic_force(const Real* q, const Real* v, Real* f) const override;
    bool has_potential() const override { return is_conservative(model_); }
    Real potential(const Real& t, const Real* q) const override;
    int bodies() const override { return static_cast<int>(bodies_.size()); }
    void read(const Real* y, BodyState* states) const override;
    void write(const BodyState* states, Real* y) const override;

    std::string reason(Status status) const override { return status == Status::turn_lost ? turns_.reason() : ""; }
    Status begin_step(const Real& t, const Real& h, const Real* y) override;
    Status end_step(Status result, const Real& t, Real* y) override;
    void read_angles(const Real* q, SpringAngle* angles) const override;

    void to_space_axes(const Real* q, const Real* v, Real* turned) const override;
    void from_space_axes(const Real* q, const Real* turned, Real* v) const override;

  private:
    struct Pivoted {
        Real mass;
        Mat3 J_O, J_O_inverse;
        Vec3 pivot, lever;
    };
    Vec3 gravity_torque(const Pivoted& body, const Eigen::Map<const Mat3>& R, const Vec3& g) const {
        return body.lever.cross(body.mass * (R.transpose() * g));
    }
    Motion motion(const Real* q, const Real* v, int body) const;
    /// Calls f(body, moment of a force about the fixed point of the body, in body axes).
    template <class F>
    void each_moment(const Real& t, const Real* q, const Real* v, F f) const;

    Model model_;
    Turns turns_;
    std::vector<Pivoted> bodies_;
    bool forces_;  // whether anything but gravity acts
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
