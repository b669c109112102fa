// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "mechanics/system.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// v <- v + time M^{-1} f(t, q), f the forces that have a potential [N, N m]: the other half of a splitting beside free
/// motion, for bodies without joints.
class Kick {
  public:
    explicit Kick(System& system)
        : system_(system), force_(static_cast<std::size_t>(system.velocities())), rate_(force_) {}

    Status operator()(const Real& t, const Real& time, Real* y) {
        if (time == 0) return Status::ok;
        system_.count_evaluation();
        system_.conservative_force(t, y, force_.data());
        const Status status = system_.solve_kkt(t, y, force_.data(), nullptr, rate_.data(), nullptr);
        Real* v = system_.v(y);
        for (std::size_t i = 0; i < rate_.size(); ++i) v[i] += time * rate_[i];
        return status;
    }

  private:
    System& system_;
    std::vector<Real> force_, rate_;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
