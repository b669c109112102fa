// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mechanics/actions/acted_upon.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Where methods move states by exponentials of slopes, and of logarithms of states, y' = y z: in TG, or in the group that a formulation has in its
/// place (mechanics/actions/state_action.hpp). A method that moves them in no other way says .takes_actions
/// (methods/contract/method.hpp).
class StateSpace {
  public:
    explicit StateSpace(System& system) : system_(system), action_(action_on(system)) {}

    const Group& group() const { return action_ ? static_cast<const Group&>(*action_) : system_.state_group(); }
    bool is_tangent_group() const { return !action_; }

    /// z in the algebra of the group. Counted as a solve of the dynamics.
    Status slope(const Real& t, const Real* y, Real* z) {
        const Status status = system_.vector_field(t, y, z);
        if (action_ && status == Status::ok) action_->from_tangent(y, z);
        return status;
    }
    /// The estimate of an error at y becomes (dq, dv), whatever the group.
    void to_tangent(const Real* y, Real* error) const {
        if (action_) action_->to_tangent(y, error);
    }

  private:
    System& system_;
    const StateAction* action_;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
