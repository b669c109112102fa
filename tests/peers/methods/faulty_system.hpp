// SPDX-License-Identifier: BSD-3-Clause
//
// A system that forwards all that baselines call, and spoils its dynamics without saying so: a method that does not
// look is deceived.
#pragma once

#include "mechanics/system.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

class FaultySystem final : public System {
  public:
    /// From the solve of this number on, `count` of them are spoiled.
    struct Fault {
        long from = 0, count = 0;
        Real value = 0;
    };

    FaultySystem(std::unique_ptr<System> sound, const Fault& fault)
        : System(std::shared_ptr<const Group>(std::shared_ptr<void>(), &sound->group())),
          sound_(std::move(sound)),
          fault_(fault) {}

    int constraints() const override { return sound_->constraints(); }
    int mass_block() const override { return sound_->mass_block(); }
    int bodies() const override { return sound_->bodies(); }
    void read(const Real* q, BodyState* states) const override { sound_->read(q, states); }
    void write(const BodyState* states, Real* q) const override { sound_->write(states, q); }
    void row_scale(Real* scale) const override { sound_->row_scale(scale); }
    void position_scale(const Real* q, Real* size) const override { sound_->position_scale(q, size); }
    Status accelerations(const Real& t, const Real* q, const Real* v, Real* dv, Real* lambda) override {
        const Status status = sound_->accelerations(t, q, v, dv, lambda);
        if (spoiled()) dv[velocities() - 1] = fault_.value;
        return status;
    }
    Status solve_kkt(const Real& t, const Real* q, const Real* f, const Real* c, Real* a, Real* lambda) override {
        return sound_->solve_kkt(t, q, f, c, a, lambda);
    }
    void mass(const Real* q, Real* blocks) const override { sound_->mass(q, blocks); }
    void solve_mass(const Real* q, const Real* f, Real* a) const override { sound_->solve_mass(q, f, a); }
    void applied_force(const Real& t, const Real* q, const Real* v, Real* f) const override {
        sound_->applied_force(t, q, v, f);
        if (spoiled()) f[velocities() - 1] = fault_.value;
    }
    void gyroscopic_force(const Real* q, const Real* v, Real* f) const override { sound_->gyroscopic_force(q, v, f); }
    void position_residual(const Real& t, const Real* q, Real* phi) const override {
        sound_->position_residual(t, q, phi);
    }
    void velocity_residual(const Real& t, const Real* q, const Real* v, Real* residual) const override {
        sound_->velocity_residual(t, q, v, residual);
    }
    void acceleration_bias(const Real& t, const Real* q, const Real* v, Real* xi) const override {
        sound_->acceleration_bias(t, q, v, xi);
    }
    void jacobian(const Real& t, const Real* q, Real* C) const override { sound_->jacobian(t, q, C); }
    std::vector<ConstraintRow> constraint_rows() const override { return sound_->constraint_rows(); }

  private:
    bool spoiled() const {
        const long solve = solves_++;
        return solve >= fault_.from && solve < fault_.from + fault_.count;
    }

    std::unique_ptr<System> sound_;
    Fault fault_;
    mutable long solves_ = 0;  // solves, or evaluations of forces
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
