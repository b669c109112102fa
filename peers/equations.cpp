// SPDX-License-Identifier: BSD-3-Clause
#include "peers/equations.hpp"

#include <algorithm>
#include <limits>

#include "mechanics/system.hpp"
#include "methods/baseline/quaternion.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// False where an entry is not finite, or the sum overflows.
bool is_finite(const Real* x, std::size_t n) {
    Real sum = 0;
    for (std::size_t i = 0; i < n; ++i) sum += x[i];
    return isfinite(sum);
}

}  // namespace

PeerEquations::PeerEquations(System& system, const Accuracy& accuracy)
    : system_(system),
      length_(accuracy.length > 0 ? power_of_two_below(accuracy.length) : Real(1)),
      norm_(system, accuracy),
      equations_(system, std::make_shared<DirectionQuaternion>()),
      w_(equations_.size()),
      scale_(w_.size(), Real(1)),
      inverse_(scale_),
      slope_(static_cast<std::size_t>(system.state_group().dim())) {}

Status PeerEquations::start(const Real& t, const Real& span, const Real* y, Real* u) {
    forget();
    if (!is_finite(y, static_cast<std::size_t>(system_.state_group().size()))) return Status::non_finite;
    if (const Status status = system_.vector_field(t, y, slope_.data()); status != Status::ok) return status;
    rate_ = norm_.rate(slope_.data());
    if (!isfinite(rate_)) return Status::non_finite;
    choose_scales(rate_ > 0 ? rate_ : span != 0 ? Real(1 / abs(span)) : Real(1));
    read(y, u);
    return Status::ok;
}

void PeerEquations::choose_scales(const Real& rate) {
    unit_ = power_of_two_below(rate);
    Real* s = scale_.data();
    const int translations = equations_.translations();
    for (int i = 0; i < equations_.bodies(); ++i, s += equations_.stride()) std::fill_n(s, translations, length_);
    for (int i = 0; i < equations_.bodies(); ++i, s += translations + 3) {
        std::fill_n(s, translations, length_ * unit_);
        std::fill_n(s + translations, 3, unit_);
    }
    for (std::size_t i = 0; i < scale_.size(); ++i) inverse_[i] = 1 / scale_[i];
}

void PeerEquations::read(const Real* y, Real* u) {
    equations_.read(y, u);
    for (std::size_t i = 0; i < w_.size(); ++i) u[i] *= inverse_[i];
}

void PeerEquations::write(const Real* u, Real* y) {
    for (std::size_t i = 0; i < w_.size(); ++i) w_[i] = scale_[i] * u[i];
    equations_.write(w_.data(), y);
}

void PeerEquations::rates(const Real* u, const Real* z, Real* du) {
    for (std::size_t i = 0; i < w_.size(); ++i) w_[i] = scale_[i] * u[i];
    equations_.rates(w_.data(), z, 0, du);
    for (std::size_t i = 0; i < w_.size(); ++i) du[i] *= inverse_[i];
}

bool PeerEquations::derivative(const Real& t, const Real* u, Real* du) {
    for (std::size_t i = 0; i < w_.size(); ++i) w_[i] = scale_[i] * u[i];
    Status status = equations_.derivative(t, w_.data(), 0, du);
    for (std::size_t i = 0; i < w_.size(); ++i) du[i] *= inverse_[i];
    if (status == Status::ok && !is_finite(du, w_.size())) status = Status::non_finite;
    if (status == Status::ok) return true;
    fail(status);
    std::fill_n(du, w_.size(), std::numeric_limits<Real>::quiet_NaN());
    return false;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
