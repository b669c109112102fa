// SPDX-License-Identifier: BSD-3-Clause
#include "methods/control/interpolant.hpp"

#include <algorithm>

namespace kreisel {
inline namespace KREISEL_PRECISION {

Interpolant::Interpolant(System& system)
    : system_(system),
      n_(static_cast<std::size_t>(system.velocities())),
      size_(static_cast<std::size_t>(system.group().size())),
      start_(size_ + n_),
      inverse_(size_) {
    for (auto* work :
         {&u_, &du_, &ddu_, &v_, &dv_, &cubic_, &quartic_, &quintic_, &power_, &term_, &sum_, &now_, &rate_})
        work->resize(n_);
}

void Interpolant::bend(const Real* u, const Real* du, Real* bent) {
    const Group& group = system_.group();
    std::copy_n(du, n_, power_.begin());
    std::fill(sum_.begin(), sum_.end(), Real(0));
    std::fill_n(bent, n_, Real(0));
    Real factor = 1;
    for (int k = 1; k <= 5; ++k) {
        factor /= -(k + 1);
        group.bracket(u, sum_.data(), sum_.data());
        group.bracket(du, power_.data(), term_.data());
        group.bracket(u, power_.data(), power_.data());
        for (std::size_t i = 0; i < n_; ++i) {
            sum_[i] += term_[i];
            bent[i] += factor * sum_[i];
        }
    }
}

Status Interpolant::set(const Real& t, const Real& h, const Real* y0, const Real* y1) {
    const Group& group = system_.group();
    const Real *v0 = system_.v(y0), *v1 = system_.v(y1);
    evaluations_ += 2;
    if (const Status status = system_.accelerations(t, y0, v0, dv_.data(), nullptr); status != Status::ok)
        return status;
    if (const Status status = system_.accelerations(t + h, y1, v1, ddu_.data(), nullptr); status != Status::ok)
        return status;
    std::copy_n(y0, start_.size(), start_.begin());
    group.inverse(y0, inverse_.data());
    group.multiply(inverse_.data(), y1, inverse_.data());
    group.log(inverse_.data(), u_.data());
    for (std::size_t i = 0; i < n_; ++i) now_[i] = h * v1[i];
    if (!group.dexpinv_left(u_.data(), now_.data(), du_.data())) return Status::left_chart;
    bend(u_.data(), du_.data(), now_.data());
    for (std::size_t i = 0; i < n_; ++i) now_[i] = h * h * ddu_[i] - now_[i];
    if (!group.dexpinv_left(u_.data(), now_.data(), ddu_.data())) return Status::left_chart;
    for (std::size_t i = 0; i < n_; ++i) v_[i] = h * v0[i], dv_[i] *= h * h;
    h_ = h;
    find_coefficients();
    return Status::ok;
}

/// u(theta) = v theta + v'/2 theta^2 + a theta^3 + b theta^4 + c theta^5, with u, u', u'' given at theta = 1.
void Interpolant::find_coefficients() {
    for (std::size_t i = 0; i < n_; ++i) {
        const Real r0 = u_[i] - v_[i] - dv_[i] / 2;
        const Real r1 = du_[i] - v_[i] - dv_[i];
        const Real r2 = ddu_[i] - dv_[i];
        cubic_[i] = 10 * r0 - 4 * r1 + r2 / 2;
        quartic_[i] = -15 * r0 + 7 * r1 - r2;
        quintic_[i] = 6 * r0 - 3 * r1 + r2 / 2;
    }
}

void Interpolant::at(const Real& theta, Real* y) {
    for (std::size_t i = 0; i < n_; ++i) {
        const Real a = cubic_[i], b = quartic_[i], c = quintic_[i];
        now_[i] = theta * (v_[i] + theta * (dv_[i] / 2 + theta * (a + theta * (b + theta * c))));
        rate_[i] = (v_[i] + theta * (dv_[i] + theta * (3 * a + theta * (4 * b + theta * 5 * c)))) / h_;
        term_[i] = -now_[i];
    }
    system_.group().append_exp(start_.data(), now_.data(), y);
    system_.group().dexp(term_.data(), rate_.data(), system_.v(y));
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
