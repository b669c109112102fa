// SPDX-License-Identifier: BSD-3-Clause
//
// A system that forwards to another one, except that the last entry of one quantity is replaced on demand.
#pragma once

#include <limits>

#include "mechanics/system.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

inline const Real not_a_number = std::numeric_limits<Real>::quiet_NaN();
inline const Real infinite = std::numeric_limits<Real>::infinity();

class PoisonedSystem final : public System {
  public:
    enum class What { nothing, acceleration, mass, applied, gyroscopic, position, velocity, jacobian };

    explicit PoisonedSystem(System& healthy)
        : System(std::shared_ptr<const Group>(std::shared_ptr<void>(), &healthy.group())), healthy_(healthy) {}

    What what = What::nothing;
    Real poison = 0;

    int constraints() const override { return healthy_.constraints(); }
    int mass_block() const override { return healthy_.mass_block(); }
    void row_scale(Real* scale) const override { healthy_.row_scale(scale); }
    void position_scale(const Real* q, Real* size) const override { healthy_.position_scale(q, size); }
    /// A system that meets NaN reports it.
    Status accelerations(const Real& t, const Real* q, const Real* v, Real* dv, Real* lambda) override {
        const Status status = healthy_.accelerations(t, q, v, dv, lambda);
        return what == What::acceleration ? Status::non_finite : status;
    }
    Status solve_kkt(const Real& t, const Real* q, const Real* f, const Real* c, Real* a, Real* lambda) override {
        return healthy_.solve_kkt(t, q, f, c, a, lambda);
    }
    bool mass_is_constant() const override { return false; }
    void mass(const Real* q, Real* blocks) const override {
        healthy_.mass(q, blocks);
        spoil(What::mass, blocks, velocities() * mass_block());
    }
    void applied_force(const Real& t, const Real* q, const Real* v, Real* f) const override {
        healthy_.applied_force(t, q, v, f);
        spoil(What::applied, f, velocities());
    }
    void gyroscopic_force(const Real* q, const Real* v, Real* f) const override {
        healthy_.gyroscopic_force(q, v, f);
        spoil(What::gyroscopic, f, velocities());
    }
    void position_residual(const Real& t, const Real* q, Real* phi) const override {
        healthy_.position_residual(t, q, phi);
        spoil(What::position, phi, constraints());
    }
    void velocity_residual(const Real& t, const Real* q, const Real* v, Real* residual) const override {
        healthy_.velocity_residual(t, q, v, residual);
        spoil(What::velocity, residual, constraints());
    }
    void jacobian(const Real& t, const Real* q, Real* C) const override {
        healthy_.jacobian(t, q, C);
        spoil(What::jacobian, C, constraints() * velocities());
    }

  private:
    void spoil(What which, Real* values, int count) const {
        if (what == which) values[count - 1] = poison;
    }

    System& healthy_;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
