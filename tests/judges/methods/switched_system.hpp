// SPDX-License-Identifier: BSD-3-Clause
//
// One of two systems on the same group, exchanged between steps or in the middle of one, counting its solves, including
// those that a method requests without `evaluate`.
#pragma once

#include "mechanics/system.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

class SwitchedSystem final : public System {
  public:
    /// Both outlive this object.
    SwitchedSystem(System& first, System& second)
        : System(std::shared_ptr<const Group>(std::shared_ptr<void>(), &first.group())),
          first_(first),
          second_(second) {}

    /// The second system takes over after this many more solves of the dynamics by the first; negative: never.
    int solves_until_switch = -1;
    long solves = 0;  ///< of the dynamics since construction

    int constraints() const override { return now().constraints(); }
    int mass_block() const override { return now().mass_block(); }
    int bodies() const override { return now().bodies(); }
    void row_scale(Real* scale) const override { now().row_scale(scale); }
    void position_scale(const Real* q, Real* size) const override { now().position_scale(q, size); }
    Status accelerations(const Real& t, const Real* q, const Real* v, Real* dv, Real* lambda) override {
        System& answering = now();
        ++solves;
        if (solves_until_switch > 0) --solves_until_switch;
        return answering.accelerations(t, q, v, dv, lambda);
    }
    Status solve_kkt(const Real& t, const Real* q, const Real* f, const Real* c, Real* a, Real* lambda) override {
        return now().solve_kkt(t, q, f, c, a, lambda);
    }
    bool mass_is_constant() const override { return false; }
    void mass(const Real* q, Real* blocks) const override { now().mass(q, blocks); }
    void applied_force(const Real& t, const Real* q, const Real* v, Real* f) const override {
        now().applied_force(t, q, v, f);
    }
    void gyroscopic_force(const Real* q, const Real* v, Real* f) const override { now().gyroscopic_force(q, v, f); }
    void position_residual(const Real& t, const Real* q, Real* phi) const override {
        now().position_residual(t, q, phi);
    }
    void velocity_residual(const Real& t, const Real* q, const Real* v, Real* residual) const override {
        now().velocity_residual(t, q, v, residual);
    }
    void jacobian(const Real& t, const Real* q, Real* C) const override { now().jacobian(t, q, C); }
    Status begin_step(const Real& t, const Real& h, const Real* y) override {
        second_.begin_step(t, h, y);
        return now().begin_step(t, h, y);
    }
    Status end_step(Status result, const Real& t, Real* y) override { return now().end_step(result, t, y); }

  private:
    System& now() const { return solves_until_switch == 0 ? second_ : first_; }

    System &first_, &second_;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
