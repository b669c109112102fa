// SPDX-License-Identifier: BSD-3-Clause
#include "peers/sundials/index1_residual.hpp"

#include <algorithm>

#include "mechanics/system.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

Index1Residual::Index1Residual(System& system, PeerEquations& equations)
    : system_(system),
      equations_(equations),
      u_size_(equations.size()),
      n_(system.velocities()),
      y_(static_cast<std::size_t>(system.state_group().size())),
      z_(static_cast<std::size_t>(2 * n_)),
      lambda_(static_cast<std::size_t>(system.constraints())),
      force_(static_cast<std::size_t>(n_)),
      other_(force_),
      mass_(static_cast<std::size_t>(n_ * system.mass_block())),
      row_unit_(lambda_),
      multiplier_unit_(lambda_) {}

void Index1Residual::choose_scales(const Real* q) {
    system_.mass(q, mass_.data());
    system_.row_scale(row_unit_.data());
    const Real rate = equations_.unit_rate(), length = equations_.length();
    const Real force = power_of_two_below(mass_[0]) * length * rate * rate;
    const std::vector<ConstraintRow> rows = system_.constraint_rows();
    for (std::size_t i = 0; i < rows.size(); ++i) {
        multiplier_unit_[i] = rows[i].direction ? Real(force * length) : force;
        row_unit_[i] *= rate * rate;
    }
}

Status Index1Residual::start(const Real& t, const Real* u, Real* x, Real* dx) {
    equations_.write_labels(y_.data());
    equations_.write(u, y_.data());
    choose_scales(y_.data());
    const Real* v = system_.v(y_.data());
    std::copy_n(v, n_, z_.begin());
    const Status status = system_.accelerations(t, y_.data(), v, system_.dv(z_.data()), lambda_.data());
    if (status != Status::ok) return status;
    std::copy_n(u, u_size_, x);
    equations_.rates(u, z_.data(), dx);
    for (std::size_t i = 0; i < lambda_.size(); ++i)
        x[u_size_ + i] = lambda_[i] / multiplier_unit_[i], dx[u_size_ + i] = 0;
    Real sum = 0;
    for (std::size_t i = 0; i < size(); ++i) sum += x[i] + dx[i];
    return isfinite(sum) ? Status::ok : Status::non_finite;
}

void Index1Residual::multipliers(const Real* x, Real* lambda) const {
    for (std::size_t i = 0; i < multiplier_unit_.size(); ++i) lambda[i] = multiplier_unit_[i] * x[u_size_ + i];
}

bool Index1Residual::evaluate(const Real& t, const Real* x, const Real* dx, Real* F) {
    system_.count_evaluation();
    equations_.write(x, y_.data());
    const Real *q = y_.data(), *v = system_.v(y_.data());
    const std::size_t at_v = u_size_ - static_cast<std::size_t>(n_);
    const Real* unit = equations_.scales().data() + at_v;
    Real* dv = system_.dv(z_.data());
    std::copy_n(v, n_, z_.begin());
    for (int i = 0; i < n_; ++i) dv[i] = unit[i] * dx[at_v + static_cast<std::size_t>(i)];
    multipliers(x, lambda_.data());

    equations_.rates(x, z_.data(), F);
    for (std::size_t i = 0; i < at_v; ++i) F[i] = dx[i] - F[i];

    system_.apply_jacobian_transpose(t, q, lambda_.data(), force_.data());
    system_.applied_force(t, q, v, other_.data());
    for (std::size_t i = 0; i < force_.size(); ++i) force_[i] -= other_[i];
    system_.gyroscopic_force(q, v, other_.data());
    for (std::size_t i = 0; i < force_.size(); ++i) force_[i] -= other_[i];
    system_.solve_mass(q, force_.data(), other_.data());
    for (std::size_t i = 0; i < other_.size(); ++i) F[at_v + i] = dx[at_v + i] + other_[i] / unit[i];

    Real* rows = F + u_size_;
    system_.apply_jacobian(t, q, dv, rows);
    system_.acceleration_bias(t, q, v, lambda_.data());
    for (std::size_t i = 0; i < lambda_.size(); ++i) rows[i] = (rows[i] - lambda_[i]) / row_unit_[i];

    Real sum = 0;
    for (std::size_t i = 0; i < size(); ++i) sum += F[i];
    return isfinite(sum);
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
