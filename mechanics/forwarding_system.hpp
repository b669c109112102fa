// SPDX-License-Identifier: BSD-3-Clause
//
// A system that forwards every call to another one: the base of stabilisations and of test doubles, which override what
// they change. Nothing falls back to what System itself returns, for a body without constraints;
// tests/mechanics/forwarding.cpp sees to that.
#pragma once

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "mechanics/actions/acted_upon.hpp"
#include "mechanics/solve/pivot_record.hpp"
#include "mechanics/space_axes.hpp"
#include "mechanics/system.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

class ForwardingSystem : public System, public SpaceAxes, public PivotRecord, public ActedUpon {
  public:
    /// `inner` outlives this object.
    explicit ForwardingSystem(System& inner)
        : System(std::shared_ptr<const Group>(std::shared_ptr<void>(), &inner.group())), inner_(&inner) {
        set_integrals(inner.integrals());
    }
    explicit ForwardingSystem(std::unique_ptr<System> inner) : ForwardingSystem(*inner) { owned_ = std::move(inner); }

    int constraints() const override { return inner().constraints(); }
    int position_constraints() const override { return inner().position_constraints(); }

    Status accelerations(const Real& t, const Real* q, const Real* v, Real* dv, Real* lambda) override {
        return inner().accelerations(t, q, v, dv, lambda);
    }
    Status solve_kkt(const Real& t, const Real* q, const Real* f, const Real* c, Real* a, Real* lambda) override {
        return inner().solve_kkt(t, q, f, c, a, lambda);
    }
    Status prepare_kkt(const Real& t, const Real* q) override { return inner().prepare_kkt(t, q); }
    Status solve_prepared(const Real& t, const Real* q, const Real* f, const Real* c, Real* a, Real* lambda) override {
        return inner().solve_prepared(t, q, f, c, a, lambda);
    }
    Status minimise_multipliers(const Real& t, const Real* q, Real* lambda) override {
        return inner().minimise_multipliers(t, q, lambda);
    }
    Real kkt_round_off() const override { return inner().kkt_round_off(); }
    Real least_pivot() override {
        auto* record = dynamic_cast<PivotRecord*>(&inner());
        return record ? record->least_pivot() : Real(1);
    }

    const StateAction* action() const override { return action_on(inner()); }

    int mass_block() const override { return inner().mass_block(); }
    bool mass_is_constant() const override { return inner().mass_is_constant(); }
    void mass(const Real* q, Real* blocks) const override { inner().mass(q, blocks); }
    void solve_mass(const Real* q, const Real* f, Real* a) const override { inner().solve_mass(q, f, a); }
    void applied_force(const Real& t, const Real* q, const Real* v, Real* f) const override {
        inner().applied_force(t, q, v, f);
    }
    void gyroscopic_force(const Real* q, const Real* v, Real* f) const override { inner().gyroscopic_force(q, v, f); }
    void conservative_force(const Real& t, const Real* q, Real* f) const override {
        inner().conservative_force(t, q, f);
    }
    void dissipative_force(const Real& t, const Real* q, const Real* v, Real* f) const override {
        inner().dissipative_force(t, q, v, f);
    }
    bool is_dissipative() const override { return inner().is_dissipative(); }
    bool has_potential() const override { return inner().has_potential(); }
    Real potential(const Real& t, const Real* q) const override { return inner().potential(t, q); }

    void position_residual(const Real& t, const Real* q, Real* phi) const override {
        inner().position_residual(t, q, phi);
    }
    void jacobian(const Real& t, const Real* q, Real* C) const override { inner().jacobian(t, q, C); }
    void apply_jacobian(const Real& t, const Real* q, const Real* v, Real* product) const override {
        inner().apply_jacobian(t, q, v, product);
    }
    void apply_jacobian_transpose(const Real& t, const Real* q, const Real* lambda, Real* f) const override {
        inner().apply_jacobian_transpose(t, q, lambda, f);
    }
    void velocity_bias(const Real& t, const Real* q, Real* b) const override { inner().velocity_bias(t, q, b); }
    void velocity_residual(const Real& t, const Real* q, const Real* v, Real* residual) const override {
        inner().velocity_residual(t, q, v, residual);
    }
    void acceleration_bias(const Real& t, const Real* q, const Real* v, Real* xi) const override {
        inner().acceleration_bias(t, q, v, xi);
    }
    void row_scale(Real* scale) const override { inner().row_scale(scale); }
    void position_scale(const Real* q, Real* scale) const override { inner().position_scale(q, scale); }
    bool has_ambient_jacobian() const override { return inner().has_ambient_jacobian(); }
    void ambient_jacobian(const Real& t, const Real* q, const Real* v, Real* G) const override {
        inner().ambient_jacobian(t, q, v, G);
    }
    void complement_diagonal(const Real& t, const Real* q, Real* diagonal) const override {
        inner().complement_diagonal(t, q, diagonal);
    }
    ConstraintRank constraint_rank() const override { return inner().constraint_rank(); }
    std::vector<ConstraintRow> constraint_rows() const override { return inner().constraint_rows(); }
    bool is_unique(int row) const override { return inner().is_unique(row); }
    Status reactions(const Real& t, const Real* q, const Real* v, const Real* lambda, JointReaction* out) override {
        return inner().reactions(t, q, v, lambda, out);
    }
    std::string reason(Status status) const override { return inner().reason(status); }

    Status begin_step(const Real& t, const Real& h, const Real* y) override { return inner().begin_step(t, h, y); }
    Status end_step(Status result, const Real& t, Real* y) override { return inner().end_step(result, t, y); }
    void read_angles(const Real* q, SpringAngle* angles) const override { inner().read_angles(q, angles); }

    int bodies() const override { return inner().bodies(); }
    void read(const Real* y, BodyState* states) const override { inner().read(y, states); }
    void write(const BodyState* states, Real* y) const override { inner().write(states, y); }
    /// Where the other one has no axes of its own, a copy.
    void to_space_axes(const Real* q, const Real* v, Real* turned) const override {
        const auto* axes = dynamic_cast<const SpaceAxes*>(&inner());
        axes ? axes->to_space_axes(q, v, turned) : static_cast<void>(std::copy_n(v, velocities(), turned));
    }
    void from_space_axes(const Real* q, const Real* turned, Real* v) const override {
        const auto* axes = dynamic_cast<const SpaceAxes*>(&inner());
        axes ? axes->from_space_axes(q, turned, v) : static_cast<void>(std::copy_n(turned, velocities(), v));
    }

  protected:
    /// Where calls go.
    virtual System& inner() const { return *inner_; }

  private:
    System* inner_;
    std::unique_ptr<System> owned_;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
