// SPDX-License-Identifier: BSD-3-Clause
//
// A system that forwards to another one, except that the last entry of one quantity is replaced on demand.
#pragma once

#include <limits>

#include "mechanics/forwarding_system.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

inline const Real not_a_number = std::numeric_limits<Real>::quiet_NaN();
inline const Real infinite = std::numeric_limits<Real>::infinity();

class PoisonedSystem final : public ForwardingSystem {
  public:
    enum class What { nothing, acceleration, mass, applied, gyroscopic, position, velocity, jacobian };

    /// `healthy` outlives this object.
    explicit PoisonedSystem(System& healthy) : ForwardingSystem(healthy) {}

    What what = What::nothing;
    Real poison = 0;

    /// A system that meets NaN reports it.
    Status accelerations(const Real& t, const Real* q, const Real* v, Real* dv, Real* lambda) override {
        const Status status = ForwardingSystem::accelerations(t, q, v, dv, lambda);
        return what == What::acceleration ? Status::non_finite : status;
    }
    bool mass_is_constant() const override { return false; }
    void mass(const Real* q, Real* blocks) const override {
        ForwardingSystem::mass(q, blocks);
        spoil(What::mass, blocks, velocities() * mass_block());
    }
    void applied_force(const Real& t, const Real* q, const Real* v, Real* f) const override {
        ForwardingSystem::applied_force(t, q, v, f);
        spoil(What::applied, f, velocities());
    }
    void gyroscopic_force(const Real* q, const Real* v, Real* f) const override {
        ForwardingSystem::gyroscopic_force(q, v, f);
        spoil(What::gyroscopic, f, velocities());
    }
    void position_residual(const Real& t, const Real* q, Real* phi) const override {
        ForwardingSystem::position_residual(t, q, phi);
        spoil(What::position, phi, constraints());
    }
    void velocity_residual(const Real& t, const Real* q, const Real* v, Real* residual) const override {
        ForwardingSystem::velocity_residual(t, q, v, residual);
        spoil(What::velocity, residual, constraints());
    }
    void jacobian(const Real& t, const Real* q, Real* C) const override {
        ForwardingSystem::jacobian(t, q, C);
        spoil(What::jacobian, C, constraints() * velocities());
    }

    // From the matrices and forces above, poison included.
    void solve_mass(const Real* q, const Real* f, Real* a) const override { System::solve_mass(q, f, a); }
    void apply_jacobian(const Real& t, const Real* q, const Real* v, Real* product) const override {
        System::apply_jacobian(t, q, v, product);
    }
    void apply_jacobian_transpose(const Real& t, const Real* q, const Real* lambda, Real* f) const override {
        System::apply_jacobian_transpose(t, q, lambda, f);
    }
    void complement_diagonal(const Real& t, const Real* q, Real* diagonal) const override {
        System::complement_diagonal(t, q, diagonal);
    }
    void conservative_force(const Real& t, const Real* q, Real* f) const override {
        System::conservative_force(t, q, f);
    }
    void dissipative_force(const Real& t, const Real* q, const Real* v, Real* f) const override {
        System::dissipative_force(t, q, v, f);
    }

  private:
    void spoil(What which, Real* values, int count) const {
        if (what == which) values[count - 1] = poison;
    }
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
