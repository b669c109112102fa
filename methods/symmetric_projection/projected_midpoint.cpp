// SPDX-License-Identifier: BSD-3-Clause
#include "methods/symmetric_projection/projected_midpoint.hpp"

#include <algorithm>

namespace kreisel {
inline namespace KREISEL_PRECISION {

void ProjectedMidpoint::guess(const VecX& change, Real* slopes) const { std::copy_n(change.data(), n_, slopes); }

void ProjectedMidpoint::place_step(const Real* slopes) {
    middle_v_ = moved_ + Eigen::Map<const VecX>(slopes, n_) / 2;
    u_ = h_ / 2 * middle_v_;
    system_.group().append_exp(start_.data(), u_.data(), middle_.data());
    u_ = h_ * middle_v_;
    system_.group().append_exp(start_.data(), u_.data(), free_.data());
}

Status ProjectedMidpoint::step_residual(const Real* slopes, Real* r) {
    const Status status = system_.evaluate(t_ + h_ / 2, middle_.data(), middle_v_.data(), f_.data());
    Eigen::Map<VecX>(r, n_) = Eigen::Map<const VecX>(slopes, n_) - h_ * f_;
    return status;
}

void ProjectedMidpoint::add_change(const Real* slopes, const Real& sign, VecX& to) const {
    to += sign * Eigen::Map<const VecX>(slopes, n_);
}

/// V = v~ + w/2.
void ProjectedMidpoint::add_increment(const Real* slopes, const Real& sign, VecX& to) const {
    to += sign / 2 * Eigen::Map<const VecX>(slopes, n_);
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
