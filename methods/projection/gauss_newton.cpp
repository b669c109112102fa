// SPDX-License-Identifier: BSD-3-Clause
#include "methods/projection/gauss_newton.hpp"

#include <algorithm>

#include "mechanics/system.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

constexpr int most_iterations = 25;

/// A row is at round-off below this fraction of its terms. Iterations that no longer halve the largest row have
/// converged too, if it is at most `stagnation` of the round-off of places; otherwise they have failed.
const Real round_off = 4 * epsilon, stagnation = 1000 * round_off;

bool all_finite(const std::vector<Real>& values) {
    return std::all_of(values.begin(), values.end(), [](const Real& x) { return isfinite(x); });
}

}  // namespace

GaussNewtonProjection::GaussNewtonProjection(System& system)
    : system_(system),
      zero_force_(static_cast<std::size_t>(system.velocities()), Real(0)),
      residual_(static_cast<std::size_t>(system.constraints())),
      terms_(static_cast<std::size_t>(system.position_constraints())),
      scale_(residual_.size()),
      delta_(zero_force_.size()) {
    system.row_scale(scale_.data());
}

/// The largest position row relative to its terms.
Real GaussNewtonProjection::relative_residual() const {
    Real largest = 0;
    for (std::size_t i = 0; i < terms_.size(); ++i)
        if (residual_[i] != 0) largest = max(largest, Real(abs(residual_[i]) / terms_[i]));
    return largest;
}

/// Where the mechanism is far from the origin, a redundant row is known only as well as the others, relative to their
/// scales; this includes rows that compare directions.
bool GaussNewtonProjection::stands_still() const {
    Real remoteness = 1;
    for (std::size_t i = 0; i < terms_.size(); ++i) remoteness = max(remoteness, Real(terms_[i] / scale_[i]));
    for (std::size_t i = 0; i < terms_.size(); ++i)
        if (!(abs(residual_[i]) <= stagnation * max(terms_[i], Real(remoteness * scale_[i])))) return false;
    return true;
}

Status GaussNewtonProjection::correction(const Real& t, const Real* q) {
    ++iterations_;
    for (Real& r : residual_) r = -r;
    return system_.solve_kkt(t, q, zero_force_.data(), residual_.data(), delta_.data(), nullptr);
}

Status GaussNewtonProjection::project_position(const Real& t, Real* y) {
    if (residual_.empty()) return Status::ok;
    system_.position_scale(y, terms_.data());
    Real previous = std::numeric_limits<Real>::max();
    for (int i = 0; i < most_iterations; ++i) {
        system_.position_residual(t, y, residual_.data());
        std::fill(residual_.begin() + system_.position_constraints(), residual_.end(), Real(0));
        if (!all_finite(residual_)) return Status::non_finite;  // NaN compares as false, and would pass below
        const Real size = relative_residual();
        if (size <= round_off || (2 * size > previous && stands_still())) return Status::ok;
        previous = size;
        if (const Status status = correction(t, y); status != Status::ok) return status;
        system_.group().append_exp(y, delta_.data(), y);
    }
    return Status::projection_failed;
}

Status GaussNewtonProjection::project_velocity(const Real& t, Real* y) {
    if (residual_.empty()) return Status::ok;
    Real* v = system_.v(y);
    system_.velocity_residual(t, y, v, residual_.data());
    if (!all_finite(residual_)) return Status::non_finite;
    if (const Status status = correction(t, y); status != Status::ok) return status;
    for (std::size_t i = 0; i < delta_.size(); ++i) v[i] += delta_[i];
    return Status::ok;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
