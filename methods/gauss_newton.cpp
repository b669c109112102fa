// SPDX-License-Identifier: BSD-3-Clause
#include "methods/gauss_newton.hpp"

#include <algorithm>

#include "mechanics/system.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

constexpr int most_iterations = 25;

Real largest(const std::vector<Real>& values) {
    Real size = 0;
    for (const Real& x : values) size = max(size, Real(abs(x)));
    return size;
}

bool all_finite(const std::vector<Real>& values) {
    return std::all_of(values.begin(), values.end(), [](const Real& x) { return isfinite(x); });
}

}  // namespace

GaussNewtonProjection::GaussNewtonProjection(System& system)
    : system_(system),
      zero_force_(static_cast<std::size_t>(system.velocities()), Real(0)),
      residual_(static_cast<std::size_t>(system.constraints())),
      delta_(zero_force_.size()) {
    std::vector<Real> scale(residual_.size());
    system.row_scale(scale.data());
    tolerance_ = 8 * epsilon * largest(scale);
}

Status GaussNewtonProjection::correction(const Real& t, const Real* q) {
    ++iterations_;
    for (Real& r : residual_) r = -r;
    return system_.solve_kkt(t, q, zero_force_.data(), residual_.data(), delta_.data(), nullptr);
}

Status GaussNewtonProjection::project_position(const Real& t, Real* y) {
    if (residual_.empty()) return Status::ok;
    Real previous = std::numeric_limits<Real>::max();
    for (int i = 0; i < most_iterations; ++i) {
        system_.position_residual(t, y, residual_.data());
        std::fill(residual_.begin() + system_.position_constraints(), residual_.end(), Real(0));
        if (!all_finite(residual_)) return Status::non_finite;  // not seen by `largest`: NaN compares as false
        const Real size = largest(residual_);
        // Convergence is at least linear, so a residual that stops falling has met round-off, or will not converge.
        if (size <= tolerance_) return Status::ok;
        if (2 * size > previous && size <= 1000 * tolerance_) return Status::ok;
        previous = size;
        if (const Status status = correction(t, y); status != Status::ok) return status;
        system_.group().append_exp(y, delta_.data(), y);
    }
    return Status::projection_failed;
}

Status GaussNewtonProjection::project_velocity(const Real& t, Real* y) {
    if (residual_.empty()) return Status::ok;
    Real* v = y + system_.group().size();
    system_.velocity_residual(t, y, v, residual_.data());
    if (!all_finite(residual_)) return Status::non_finite;
    if (const Status status = correction(t, y); status != Status::ok) return status;
    for (std::size_t i = 0; i < delta_.size(); ++i) v[i] += delta_[i];
    return Status::ok;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
