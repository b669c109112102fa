// SPDX-License-Identifier: BSD-3-Clause
//
// A system whose accelerations are a script: the i-th call of a step returns the i-th vector, whatever the state. The
// velocities of the stages, and with them their slopes, then follow from the tableau alone. Records where it was
// called.
#pragma once

#include <stdexcept>
#include <vector>

#include "lie/linear.hpp"
#include "mechanics/system.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

class ScriptedSystem final : public System {
  public:
    struct Call {
        Real t;
        VecX q, v;  ///< q as stored
    };

    ScriptedSystem(std::shared_ptr<const Group> group, std::vector<VecX> script)
        : System(std::move(group)), script_(std::move(script)) {}

    /// Throws std::out_of_range at a call beyond the script.
    Status accelerations(const Real& t, const Real* q, const Real* v, Real* dv, Real*) override {
        const VecX& answer = script_.at(calls_.size());
        calls_.push_back({t, Eigen::Map<const VecX>(q, group().size()), Eigen::Map<const VecX>(v, velocities())});
        Eigen::Map<VecX>(dv, velocities()) = answer;
        return Status::ok;
    }

    const std::vector<Call>& calls() const { return calls_; }

  private:
    std::vector<VecX> script_;
    std::vector<Call> calls_;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
