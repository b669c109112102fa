// SPDX-License-Identifier: BSD-3-Clause
#include "methods/implicit/stabilised_equations.hpp"

#include <algorithm>

namespace kreisel {
inline namespace KREISEL_PRECISION {

StabilisedEquations::StabilisedEquations(System& system, const StepRelations& relations)
    : rate(VecX::Zero(system.velocities())),
      change(VecX::Zero(system.constraints())),
      system_(system),
      relations_(relations),
      n_(system.velocities()),
      m_(system.constraints()),
      positions_(system.position_constraints()),
      configuration_(static_cast<std::size_t>(system.group().size())),
      increment_(rate),
      velocity_(rate),
      force_(rate),
      gyroscopic_(rate),
      shift_(rate),
      rows_(change),
      impulse_(change) {}

void StabilisedEquations::place(const Real* unknowns) {
    const Eigen::Map<const VecX> x(unknowns, n_);
    velocity_ = relations_.velocity_slope * x + relations_.velocity_offset;
    increment_ = relations_.increment_slope * x + relations_.increment_offset;
    if (etas() > 0) {
        pull_back(unknowns + n_);
        increment_ -= shift_;
    }
    force_ = h_ * increment_;
    system_.group().append_exp(q_, force_.data(), configuration_.data());
}

void StabilisedEquations::pull_back(const Real* eta) {
    system_.apply_jacobian_transpose(start_, q_, eta, force_.data());
    system_.solve_mass(q_, force_.data(), shift_.data());
}

const VecX& StabilisedEquations::evaluate_forces() {
    const Real *q = configuration_.data(), *v = velocity_.data();
    system_.applied_force(end_, q, v, force_.data());
    system_.gyroscopic_force(q, v, gyroscopic_.data());
    return force_ = h_ * (force_ + gyroscopic_);
}

Status StabilisedEquations::solve_dynamics() {
    const Real* q = configuration_.data();
    if (m_ > 0) {
        system_.velocity_residual(end_, q, relations_.velocity_offset.data(), rows_.data());
        rows_ /= -relations_.velocity_slope;
    }
    if (const Status status = prepare(); status != Status::ok) return status;
    return system_.solve_prepared(end_, q, force_.data(), rows_.data(), rate.data(), impulse_.data());
}

Status StabilisedEquations::correct_positions(const Real* unknowns, Real* out) {
    const Real* q = configuration_.data();
    const Eigen::Map<const VecX> x(unknowns, n_);
    Eigen::Map<VecX> difference(out, m_);
    force_ = relations_.increment_slope * (rate - x);
    system_.apply_jacobian(end_, q, force_.data(), rows_.data());
    system_.position_residual(end_, q, out);
    rows_.head(positions_) += difference.head(positions_) / h_;
    if (m_ > positions_) {
        // - M^{-1} C^T eta
        force_ = increment_ - relations_.increment_offset - relations_.increment_slope * x;
        system_.apply_jacobian(end_, q, force_.data(), out);
        rows_.tail(m_ - positions_) = difference.tail(m_ - positions_);
    }
    force_.setZero();
    const Status status = system_.solve_prepared(end_, q, force_.data(), rows_.data(), shift_.data(), out);
    change = difference;
    return status;
}

Status StabilisedEquations::correct_rate() {
    system_.velocity_residual(end_, configuration_.data(), velocity_of_rate().data(), rows_.data());
    rows_ /= -relations_.velocity_slope;
    force_.setZero();
    const Status status =
        system_.solve_prepared(end_, configuration_.data(), force_.data(), rows_.data(), shift_.data(), nullptr);
    rate += shift_;
    return status;
}

const VecX& StabilisedEquations::position_residual() {
    system_.position_residual(end_, configuration_.data(), rows_.data());
    return rows_;
}

void StabilisedEquations::withdraw() {
    std::copy_n(q_, configuration_.size(), configuration_.begin());
    end_ = start_;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
