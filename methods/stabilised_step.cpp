// SPDX-License-Identifier: BSD-3-Clause
#include "methods/stabilised_step.hpp"

#include <algorithm>

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

std::size_t count(Eigen::Index n) { return static_cast<std::size_t>(n); }

}  // namespace

StabilisedStep::StabilisedStep(System& system)
    : velocity_slope(0),
      increment_slope(0),
      velocity_offset(VecX::Zero(system.velocities())),
      increment_offset(velocity_offset),
      system_(system),
      n_(system.velocities()),
      m_(system.constraints()),
      positions_(system.position_constraints()),
      newton_(static_cast<int>(n_ + m_ + positions_)),
      scale_(system),
      unknowns_(VecX::Zero(n_ + m_ + positions_)),
      sizes_(unknowns_),
      rows_scale_(m_),
      jacobian_before_(m_, n_),
      jacobian_(m_, n_),
      increment_(velocity_offset),
      velocity_(velocity_offset),
      rate_(velocity_offset),
      lambda_(VecX::Zero(m_)),
      applied_(velocity_offset),
      gyroscopic_(velocity_offset),
      configuration_(count(system.group().size())),
      blocks_(count(n_ * system.mass_block())) {
    system.row_scale(rows_scale_.data());
}

Status StabilisedStep::start(const Real& t, const Real& h, const Real* y) {
    newton_.forget();
    const Real* v = y + configuration_.size();
    const Status status = system_.accelerations(t, y, v, rate_.data(), m_ > 0 ? lambda_.data() : nullptr);
    if (status != Status::ok) return status;
    rate_ *= h;
    unknowns_.head(n_) = rate_;
    unknowns_.segment(n_, m_) = h * lambda_;
    unknowns_.tail(positions_).setZero();
    return Status::ok;
}

Status StabilisedStep::advance(const Real& t, const Real& h, Real* y) {
    h_ = h, end_ = t + h, q_ = y;
    system_.jacobian(t, y, jacobian_before_.data());
    measure_sizes(t, y);
    const Status status = newton_.solve(*this, sizes_.data(), unknowns_.data());
    if (status != Status::ok) return status;
    place(unknowns_.data());
    rate_ = unknowns_.head(n_);
    lambda_ = unknowns_.segment(n_, m_) / h;
    std::copy(configuration_.begin(), configuration_.end(), y);
    std::copy_n(velocity_.data(), n_, y + configuration_.size());
    return Status::ok;
}

/// Positions are met up to round-off of the joints' levers, and eta moves them by h C C^T, which is 1 along the lever
/// and |C_k|^2 across it: its size lies in the middle.
void StabilisedStep::measure_sizes(const Real& t, const Real* y) {
    scale_.measure(t, h_, y);
    std::copy(scale_.velocities().begin(), scale_.velocities().end(), sizes_.data());
    for (Eigen::Index i = 0; i < m_; ++i) sizes_[n_ + i] = scale_.impulse(jacobian_before_, i);
    for (Eigen::Index i = 0; i < positions_; ++i)
        sizes_[n_ + m_ + i] = rows_scale_[i] / (abs(h_) * jacobian_before_.row(i).norm());
}

/// q+, v+ and D for unknowns x.
void StabilisedStep::place(const Real* x) {
    const Eigen::Map<const VecX> rate(x, n_), eta(x + n_ + m_, positions_);
    velocity_ = velocity_slope * rate + velocity_offset;
    increment_ = increment_slope * rate + increment_offset;
    increment_.noalias() -= jacobian_before_.topRows(positions_).transpose() * eta;
    applied_ = h_ * increment_;
    system_.group().append_exp(q_, applied_.data(), configuration_.data());
}

void StabilisedStep::add_mass_times(const Real* rate, Real* impulse) const {
    const Eigen::Index rows = system_.mass_block();
    const Real* block = blocks_.data();
    for (Eigen::Index i = 0; i < n_; i += rows, block += rows * rows)
        Eigen::Map<VecX>(impulse + i, rows).noalias() +=
            Eigen::Map<const MatX>(block, rows, rows) * Eigen::Map<const VecX>(rate + i, rows);
}

Status StabilisedStep::residual(const Real* x, Real* r) {
    place(x);
    system_.count_evaluation();
    const Real* q = configuration_.data();
    const Real* v = velocity_.data();
    system_.mass(q, blocks_.data());
    system_.applied_force(end_, q, v, applied_.data());
    system_.gyroscopic_force(q, v, gyroscopic_.data());
    system_.jacobian(end_, q, jacobian_.data());
    Eigen::Map<VecX> dynamics(r, n_);
    dynamics = -h_ * (applied_ + gyroscopic_);
    dynamics.noalias() += jacobian_.transpose() * Eigen::Map<const VecX>(x + n_, m_);
    add_mass_times(x, r);
    Real* positions = r + n_;
    system_.position_residual(end_, q, positions);
    for (Eigen::Index i = 0; i < positions_; ++i) positions[i] /= h_;
    system_.velocity_residual(end_, q, v, positions + positions_);
    return Status::ok;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
