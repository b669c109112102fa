// SPDX-License-Identifier: BSD-3-Clause
//
// Munthe-Kaas lift of the implicit midpoint rule, the Lie midpoint method: on TG, with y = (q, v),
//   k = F(t + h/2, y exp(h k / 2)),   y+ = y exp(h k),
// that is, with V = (v + v+)/2,
//   q+ = q exp(h V),   v+ = v + h f(t + h/2, q exp(h V / 2), V),   f = v' of the index-1 form.
// The stage k is frozen along its own direction, where dexpinv is the identity, so that none is needed. Exchanging the
// ends, and h by -h, gives the same equations: the method is symmetric.
//    1/2 | 1/2
//   -----+----
//        |  1
// The unknown of the Newton iteration is w = v+ - v. Sources: midpoint rule [hairer2006], lift [munthekaas1998].
#include "mechanics/system.hpp"
#include "methods/integrator.hpp"
#include "methods/motion_scale.hpp"
#include "methods/newton.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

class ImplicitMidpoint final : public Integrator, private Equations {
  public:
    explicit ImplicitMidpoint(System& system)
        : system_(system),
          n_(static_cast<std::size_t>(system.velocities())),
          newton_(system.velocities()),
          scale_(system),
          w_(n_),
          u_(n_),
          middle_v_(n_),
          f_(n_),
          middle_q_(static_cast<std::size_t>(system.group().size())) {}

    Status start(const Real&, const Real*) override {
        newton_.forget();
        return Status::ok;
    }

    Status step(const Real& t, const Real& h, Real* y) override {
        if (h != h_) newton_.forget();
        t_ = t, h_ = h, q_ = y, v_ = y + middle_q_.size();
        if (const Status status = system_.evaluate(t, q_, v_, f_.data()); status != Status::ok) return status;
        for (std::size_t i = 0; i < n_; ++i) w_[i] = h * f_[i];
        scale_.measure(t, h, y);
        const Real* size = scale_.velocities().data();
        if (const Status status = newton_.solve(*this, size, w_.data()); status != Status::ok) return status;
        // The last iterate fulfils C w = 0 as well as Newton's correction is known, h f to the round-off of one solve.
        if (const Status status = residual(w_.data(), u_.data()); status != Status::ok) return status;
        for (std::size_t i = 0; i < n_; ++i) w_[i] = h * f_[i];
        Real* v = y + middle_q_.size();
        for (std::size_t i = 0; i < n_; ++i) {
            u_[i] = h * (v[i] + w_[i] / 2);
            v[i] += w_[i];
        }
        system_.group().append_exp(y, u_.data(), y);
        return Status::ok;
    }

  private:
    /// r = w - h f(t + h/2, q exp(h V / 2), V) with V = v + w/2.
    Status residual(const Real* w, Real* r) override {
        for (std::size_t i = 0; i < n_; ++i) {
            middle_v_[i] = v_[i] + w[i] / 2;
            u_[i] = h_ / 2 * middle_v_[i];
        }
        system_.group().append_exp(q_, u_.data(), middle_q_.data());
        const Status status = system_.evaluate(t_ + h_ / 2, middle_q_.data(), middle_v_.data(), f_.data());
        for (std::size_t i = 0; i < n_; ++i) r[i] = w[i] - h_ * f_[i];
        return status;
    }

    System& system_;
    std::size_t n_;
    Newton newton_;
    MotionScale scale_;
    std::vector<Real> w_, u_, middle_v_, f_, middle_q_;
    Real t_ = 0, h_ = 0;
    const Real *q_ = nullptr, *v_ = nullptr;  // where the step begins
};

Factory implicit_midpoint() {
    Factory factory;
    factory.make = [](System& system, const OptionValues&, const MethodDescription&) {
        return std::make_unique<ImplicitMidpoint>(system);
    };
    factory.stages = 1;
    return factory;
}

}  // namespace

KREISEL_METHOD(implicit_midpoint(), {.name = "rkmk/implicit_midpoint",
                                     .order = 2,
                                     .cites = {"hairer2006", "munthekaas1998"},
                                     .summary = "Munthe-Kaas lift of the implicit midpoint rule",
                                     .implicit = true,
                                     .symmetric = true});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
