// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "mechanics/system.hpp"
#include "methods/contract/integrator.hpp"
#include "tests/controls/broken.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// Where the rule on the group (methods/extrapolation/base.hpp) goes from y_{i-1} to y_{i+1} over odd and even i alike,
/// this one makes each odd point anew, y_{i+1} = y_i exp(h F_i): explicit midpoint steps of 2h, one after the other.
class OneSidedExtrapolation final : public Integrator {
  public:
    explicit OneSidedExtrapolation(System& system)
        : system_(system),
          n_(static_cast<std::size_t>(system.velocities())),
          size_(static_cast<std::size_t>(system.group().size())),
          first_(n_),
          rate_(n_),
          turn_(n_),
          coarse_(size_ + n_),
          fine_(coarse_),
          middle_(coarse_),
          new_(coarse_),
          error_(2 * n_) {}

    Status step(const Real& t, const Real& h, Real* y) override {
        const Status status = attempt(t, h, y, new_.data(), error_.data());
        if (status == Status::ok) std::copy(new_.begin(), new_.end(), y);
        return status;
    }

    Status attempt(const Real& t, const Real& h, const Real* y, Real* y_new, Real* error) override {
        Status status = system_.evaluate(t, y, y + size_, first_.data());
        if (status == Status::ok) status = row(t, h / 2, 2, y, coarse_);
        if (status == Status::ok) status = row(t, h / 4, 4, y, fine_);
        if (status != Status::ok) return status;
        const Group& group = system_.group();
        group.inverse(coarse_.data(), middle_.data());
        group.multiply(middle_.data(), fine_.data(), middle_.data());
        group.log(middle_.data(), error);
        for (std::size_t i = 0; i < n_; ++i) {
            error[i] /= 3, turn_[i] = 4 * error[i];
            error[n_ + i] = (fine_[size_ + i] - coarse_[size_ + i]) / 3;
            y_new[size_ + i] = coarse_[size_ + i] + 4 * error[n_ + i];
        }
        group.append_exp(coarse_.data(), turn_.data(), y_new);
        return Status::ok;
    }

  private:
    /// out = from moved by h along the slope at `at`, whose velocity changes by f.
    void move(const Real* from, const Real* at, const std::vector<Real>& f, const Real& h, Real* out) {
        for (std::size_t i = 0; i < n_; ++i) turn_[i] = h * at[size_ + i];
        for (std::size_t i = 0; i < n_; ++i) out[size_ + i] = from[size_ + i] + h * f[i];
        system_.group().append_exp(from, turn_.data(), out);
    }

    Status row(const Real& t, const Real& h, int substeps, const Real* y, std::vector<Real>& out) {
        std::copy_n(y, out.size(), out.begin());
        rate_ = first_;
        for (int i = 0; i < substeps; i += 2) {
            const Real* v = out.data() + size_;
            Status status = i == 0 ? Status::ok : system_.evaluate(t + i * h, out.data(), v, rate_.data());
            if (status != Status::ok) return status;
            move(out.data(), out.data(), rate_, h, middle_.data());
            status = system_.evaluate(t + (i + 1) * h, middle_.data(), middle_.data() + size_, rate_.data());
            if (status != Status::ok) return status;
            move(out.data(), middle_.data(), rate_, 2 * h, out.data());
        }
        return Status::ok;
    }

    System& system_;
    std::size_t n_, size_;
    std::vector<Real> first_, rate_, turn_, coarse_, fine_, middle_, new_, error_;
};

}  // namespace

Factory one_sided_extrapolation() {
    Factory factory;
    factory.make = [](System& system, const OptionValues&, const MethodDescription&) {
        return std::make_unique<OneSidedExtrapolation>(system);
    };
    factory.stages = 5;
    factory.scheme = Scheme(GroupExtrapolationScheme{2});
    return factory;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
