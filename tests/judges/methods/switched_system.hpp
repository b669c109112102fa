// SPDX-License-Identifier: BSD-3-Clause
//
// One of two systems on the same group, exchanged between steps or in the middle of one, counting its solves, including
// those that a method requests without `evaluate`.
#pragma once

#include "mechanics/forwarding_system.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

class SwitchedSystem final : public ForwardingSystem {
  public:
    /// Both outlive this object.
    SwitchedSystem(System& first, System& second) : ForwardingSystem(first), first_(first), second_(second) {}

    /// The second system takes over after this many more solves of the dynamics by the first; negative: never.
    int solves_until_switch = -1;
    long solves = 0;  ///< of the dynamics since construction

    Status accelerations(const Real& t, const Real* q, const Real* v, Real* dv, Real* lambda) override {
        System& answering = inner();
        ++solves;
        if (solves_until_switch > 0) --solves_until_switch;
        return answering.accelerations(t, q, v, dv, lambda);
    }
    bool mass_is_constant() const override { return false; }

    // The second may take over before the prepared solve, or within the step.
    Status prepare_kkt(const Real& t, const Real* q) override {
        second_.prepare_kkt(t, q);
        return inner().prepare_kkt(t, q);
    }
    Status begin_step(const Real& t, const Real& h, const Real* y) override {
        second_.begin_step(t, h, y);
        return inner().begin_step(t, h, y);
    }

  protected:
    System& inner() const override { return solves_until_switch == 0 ? second_ : first_; }

  private:
    System &first_, &second_;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
