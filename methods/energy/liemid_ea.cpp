// SPDX-License-Identifier: BSD-3-Clause
//
// LIEMID[EA] of Krysl on any group, for systems without joints: half an impulse, two free motions of h/2 by the
// midpoint Lie rule, half an impulse. With p = M v and Ad*_g = Ad_g^T,
//   p <- p + h/2 f(t, q),
//   twice: u = h/2 M^{-1} Ad*_{exp(u/2)} p,   q <- q exp(u),   p <- Ad*_{exp u} p,
//   p <- p + h/2 f(t + h, q).
// Explicit in the forces: only the increments u are implicit, each body for itself. Symmetric; momentum in space axes
// changes by impulses only. Source: [krysl2005].
#include <algorithm>

#include "mechanics/system.hpp"
#include "methods/contract/integrator.hpp"
#include "methods/implicit/block_mass.hpp"
#include "methods/implicit/motion_scale.hpp"
#include "methods/implicit/newton/newton.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

class LieMidpointFlow final : private Equations {
  public:
    explicit LieMidpointFlow(System& system)
        : system_(system),
          newton_(system.velocities()),
          scale_(system),
          u_(VecX::Zero(system.velocities())),
          half_u_(u_),
          pulled_(u_),
          turned_(u_),
          weights_(VecX::Ones(u_.size())),
          turn_(static_cast<std::size_t>(system.group().size())) {}

    void forget() { newton_.forget(), scale_.forget(); }
    void weigh(const Real* q) { scale_.weigh(q); }

    /// (q, p) after the time h of free motion, in place.
    Status advance(const Real& h, Real* q, VecX& p) {
        if (h != h_) newton_.forget();
        h_ = h, q_ = q, p_ = &p;
        system_.solve_mass(q, p.data(), u_.data());
        u_ *= h;
        size_ = scale_.of_velocity(u_.data());
        if (!isfinite(size_)) return Status::non_finite;
        scale_.to_space(q, u_.data(), turned_.data());
        if (const Status status = newton_.solve(*this, weights_, turned_.data()); status != Status::ok) return status;
        const Group& group = system_.group();
        append(u_);
        group.coAd(turn_.data(), p.data(), p.data());
        group.append_exp(q, u_.data(), q);
        return Status::ok;
    }
    long iterations() const { return newton_.iterations(); }

  private:
    /// turn_ = exp(u).
    void append(const VecX& u) {
        system_.group().identity(turn_.data());
        system_.group().append_exp(turn_.data(), u.data(), turn_.data());
    }
    Status residual(const Real* turned, Real* r) override {
        system_.count_evaluation();
        scale_.from_space(q_, turned, u_.data());
        half_u_ = u_ / 2;
        append(half_u_);
        system_.group().coAd(turn_.data(), p_->data(), pulled_.data());
        system_.solve_mass(q_, pulled_.data(), half_u_.data());
        half_u_ = u_ - h_ * half_u_;
        scale_.to_space(q_, half_u_.data(), r);
        return Status::ok;
    }
    Real size() const override { return size_; }

    System& system_;
    Newton newton_;
    MotionScale scale_;
    VecX u_, half_u_, pulled_, turned_, weights_;
    std::vector<Real> turn_;
    Real h_ = 0, size_ = 0;
    const Real* q_ = nullptr;
    const VecX* p_ = nullptr;
};

class Liemid final : public Integrator {
  public:
    explicit Liemid(System& system)
        : system_(system),
          flow_(system),
          mass_(system),
          p_(VecX::Zero(system.velocities())),
          f_(p_),
          start_(p_),
          q_(static_cast<std::size_t>(system.group().size())) {}

    Status start(const Real&, const Real*) override {
        flow_.forget();
        return Status::ok;
    }

    Status step(const Real& t, const Real& h, Real* y) override {
        if (h == 0) return system_.accelerations(t, y, system_.v(y), f_.data(), nullptr);
        std::copy_n(y, q_.size(), q_.begin());
        flow_.weigh(y), mass_.weigh(y);
        mass_.multiply(system_.v(y), p_.data());
        start_ = p_;
        push(t, h);
        for (int half = 0; half < 2; ++half)
            if (const Status status = flow_.advance(h / 2, q_.data(), p_); status != Status::ok) return status;
        push(t + h, h);
        ++work_.exponentials;
        work_.newton_iterations = flow_.iterations();
        p_ -= start_;  // M^{-1} M v is v to round-off only, of the same sign at every step
        system_.solve_mass(q_.data(), p_.data(), f_.data());
        Real sum = f_.sum();
        for (const Real& entry : q_) sum += entry;
        if (!isfinite(sum)) return Status::non_finite;
        std::copy(q_.begin(), q_.end(), y);
        Eigen::Map<VecX>(system_.v(y), f_.size()) += f_;
        return Status::ok;
    }

  private:
    void push(const Real& t, const Real& h) {
        system_.conservative_force(t, q_.data(), f_.data());
        p_ += h / 2 * f_;
    }

    System& system_;
    LieMidpointFlow flow_;
    BlockMass mass_;
    VecX p_, f_, start_;
    std::vector<Real> q_;
};

Factory liemid() {
    Factory factory;
    factory.make = [](System& system, const OptionValues&, const MethodDescription&) {
        return std::make_unique<Liemid>(system);
    };
    factory.declines = [](const System& system) -> std::string {
        if (system.is_dissipative()) return "forces that depend on velocities (dampers)";
        return system.constraints() > 0 ? "joints" : "";
    };
    return factory;
}

}  // namespace

KREISEL_METHOD(liemid(),
               {.name = "energy/liemid_ea",
                .order = 2,
                .cites = {"krysl2005"},
                .summary = "LIEMID[EA] of Krysl: impulses between free motions by the midpoint Lie rule",
                .force_evaluations = 2,
                .variable_cost = true,
                .form = Form::implicit,
                .preserves = {{Property::symmetric, Domain::potential}, {Property::momentum, Domain::potential}}});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
