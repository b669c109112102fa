// SPDX-License-Identifier: BSD-3-Clause
#include "methods/implicit/mixed_kkt.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

MixedKkt::MixedKkt(System& system)
    : system_(system),
      scale_(system),
      force_(VecX::Zero(system.velocities())),
      zero_force_(force_),
      correction_(force_),
      residual_(VecX::Zero(system.constraints())),
      shift_(residual_) {}

Status MixedKkt::solve(const Configuration& transposed, const Configuration& rows, const Real* f, const Real* c,
                       Real* a, Real* lambda) {
    constexpr int most_iterations = 200;
    const Eigen::Map<const VecX> force(f, force_.size()), right(c, residual_.size());
    Eigen::Map<VecX> multipliers(lambda, residual_.size());
    scale_.weigh(transposed.q);
    if (const Status status = system_.prepare_kkt(rows.t, rows.q); status != Status::ok) return status;
    Real previous = 0;  // none yet
    for (int i = 0; i < most_iterations; ++i) {
        system_.apply_jacobian_transpose(transposed.t, transposed.q, lambda, force_.data());
        force_ = force - force_;
        system_.solve_mass(transposed.q, force_.data(), a);
        if (residual_.size() == 0) return Status::ok;
        system_.apply_jacobian(rows.t, rows.q, a, residual_.data());
        residual_ -= right;
        const Status status = system_.solve_prepared(rows.t, rows.q, zero_force_.data(), residual_.data(),
                                                     correction_.data(), shift_.data());
        if (status != Status::ok) return status;
        const Real now = scale_.of_velocity(correction_.data());
        const Real size = max(scale_.of_velocity(a), scale_.of_impulse(f)) + now;
        // A correction that no longer decreases is round-off, or the iteration will not converge.
        const bool stands = previous > 0 && 2 * now > previous;
        if (now <= epsilon * size || (stands && now <= 4096 * system_.kkt_round_off() * size)) return Status::ok;
        previous = now;
        multipliers -= shift_;
    }
    return Status::newton_failed;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
