// SPDX-License-Identifier: BSD-3-Clause
//
// Bodies with joints as constraints: all of the system but its solves, which derived classes organise by the structure
// of the model. The rows are PointRows where all joints are spherical, as far as these go, and GeneralRows otherwise.
#pragma once

#include <algorithm>

#include "mechanics/formulations/free_bodies.hpp"
#include "mechanics/formulations/general_rows.hpp"
#include "mechanics/formulations/point_rows.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

template <class Coordinates>
class ConstrainedBodies : public FreeBodies<Coordinates> {
  public:
    explicit ConstrainedBodies(Model data)
        : Base(std::move(data)), rows_(model()), spherical_(all_spherical(model())) {}

    int constraints() const override { return rows_.places().rows(); }
    int position_constraints() const override { return rows_.places().position_rows(); }
    std::vector<ConstraintRow> constraint_rows() const override { return kreisel::constraint_rows(model()); }
    void row_scale(Real* scale) const override { rows_.scale(scale); }
    void position_scale(const Real* q, Real* size) const override {
        spherical_ ? Points::position_scale(model(), q, size) : rows_.position_scale(q, size);
    }

    void position_residual(const Real& t, const Real* q, Real* phi) const override {
        spherical_ ? Points::positions(model(), q, phi) : rows_.positions(t, q, phi);
    }
    void velocity_bias(const Real& t, const Real* q, Real* b) const override { rows_.velocity_bias(t, q, b); }
    void velocity_residual(const Real& t, const Real* q, const Real* v, Real* residual) const override {
        spherical_ ? Points::velocities(model(), q, v, residual) : rows_.velocities(t, q, v, 1, residual);
    }
    void acceleration_bias(const Real& t, const Real* q, const Real* v, Real* xi) const override {
        rows_.acceleration_bias(t, q, v, xi);
    }

    void jacobian(const Real& t, const Real* q, Real* C) const override {
        Eigen::Map<MatX> matrix(C, constraints(), this->velocities());
        rows_.jacobian(t, q, matrix);
    }
    void apply_jacobian(const Real& t, const Real* q, const Real* v, Real* product) const override {
        spherical_ ? Points::velocities(model(), q, v, product) : rows_.velocities(t, q, v, 0, product);
    }
    void apply_jacobian_transpose(const Real& t, const Real* q, const Real* lambda, Real* f) const override {
        std::fill_n(f, this->velocities(), Real(0));
        const auto add = [&](int body, const Vec3& force, const Vec3& torque) {
            this->add_wrench(q, body, force, torque, f);
        };
        spherical_ ? Points::transpose(model(), q, lambda, add) : rows_.transpose(t, q, lambda, add);
    }
    void complement_diagonal(const Real& t, const Real* q, Real* diagonal) const override {
        const auto mobility = [&](std::size_t body, const Vec3& force, const Vec3& torque) -> Real {
            return inverse_mass(model().bodies[body]) * force.squaredNorm() +
                   torque.dot(this->J_inverse(body) * torque);
        };
        rows_.complement_diagonal(t, q, mobility, diagonal);
    }
    bool has_ambient_jacobian() const override { return Points::are_polynomials && spherical_; }
    void ambient_jacobian(const Real&, const Real* q, const Real* v, Real* G) const override {
        const Eigen::Index size = this->group().size();
        Eigen::Map<MatX> matrix(G, 2 * constraints(), size + this->velocities());
        Points::ambient_jacobian(model(), q, v, size, matrix);
    }
    Status reactions(const Real& t, const Real* q, const Real*, const Real* lambda, JointReaction* out) override {
        rows_.reactions(t, q, lambda, out);
        return Status::ok;
    }

  protected:
    using Base = FreeBodies<Coordinates>;
    using Base::model;

    int row(std::size_t joint, int k) const { return rows_.places().row(joint, k); }

  private:
    using Points = PointRows<Coordinates>;

    GeneralRows<Coordinates> rows_;
    bool spherical_;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
