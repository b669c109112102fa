// SPDX-License-Identifier: BSD-3-Clause
#include "methods/extrapolation/group_midpoint.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "mechanics/system.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// Velocities are kept as increments from the start of the step: they add, and their round-off stays that of one.
class GroupMidpoint final : public ExtrapolationBase {
  public:
    GroupMidpoint(System& system, Work& work)
        : ExtrapolationBase(work),
          system_(system),
          n_(static_cast<std::size_t>(system.velocities())),
          first_(n_),
          rate_(n_),
          v_(n_),
          turn_(n_),
          dv_before_(n_),
          dv_(n_),
          q_before_(static_cast<std::size_t>(system.group().size())),
          q_(q_before_),
          origin_(q_before_),
          origin_inverse_(q_before_) {}

    Status begin(const Real& t, const Real& H, const Real* y, bool known) override {
        t_ = t, H_ = H, y_ = y, has_origin_ = false;
        return known ? Status::ok : system_.evaluate(t, system_.q(y), system_.v(y), first_.data());
    }

    Status row(int n, Real* u) override {
        const Real h = H_ / n, *v = system_.v(y_);
        std::copy_n(system_.q(y_), q_.size(), q_before_.begin());
        append(system_.q(y_), h, v, q_);
        for (std::size_t j = 0; j < n_; ++j) dv_before_[j] = 0, dv_[j] = h * first_[j];
        for (int i = 1; i < n; ++i) {
            for (std::size_t j = 0; j < n_; ++j) v_[j] = v[j] + dv_[j];
            const Status status = system_.evaluate(t_ + i * h, q_.data(), v_.data(), rate_.data());
            if (status != Status::ok) return status;
            advance(2 * h);
        }
        coordinates(u);
        std::copy(dv_.begin(), dv_.end(), u + n_);
        return Status::ok;
    }

    void state(const Real* u, Real* y) override {
        const Real* v = system_.v(y_);
        for (std::size_t i = 0; i < n_; ++i) system_.v(y)[i] = v[i] + u[n_ + i];
        system_.group().append_exp(origin_.data(), u, system_.q(y));
        ++work_.exponentials;
    }

  private:
    /// out = q exp(h v).
    void append(const Real* q, const Real& h, const Real* v, std::vector<Real>& out) {
        for (std::size_t i = 0; i < n_; ++i) turn_[i] = h * v[i];
        system_.group().append_exp(q, turn_.data(), out.data());
        ++work_.exponentials;
    }

    /// y_{i-1} becomes y_{i+1} = y_{i-1} exp(2h F_i), and they change places.
    void advance(const Real& h2) {
        append(q_before_.data(), h2, v_.data(), q_before_);
        for (std::size_t j = 0; j < n_; ++j) dv_before_[j] += h2 * rate_[j];
        std::swap(q_before_, q_);
        std::swap(dv_before_, dv_);
    }

    void coordinates(Real* u) {
        if (!has_origin_) {
            origin_ = q_;
            system_.group().inverse(origin_.data(), origin_inverse_.data());
            std::fill_n(u, n_, Real(0));
            has_origin_ = true;
            return;
        }
        system_.group().multiply(origin_inverse_.data(), q_.data(), q_.data());
        system_.group().log(q_.data(), u);
    }

    System& system_;
    std::size_t n_;
    std::vector<Real> first_, rate_, v_, turn_, dv_before_, dv_, q_before_, q_, origin_, origin_inverse_;
    Real t_ = 0, H_ = 0;
    const Real* y_ = nullptr;
    bool has_origin_ = false;
};

}  // namespace

std::unique_ptr<ExtrapolationBase> group_midpoint(System& system, Work& work) {
    return std::make_unique<GroupMidpoint>(system, work);
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
