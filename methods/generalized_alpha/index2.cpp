// SPDX-License-Identifier: BSD-3-Clause
//
// Generalised-alpha method on Lie groups in the stabilised index-2 form [bruels2012], [arnold2016]:
//   q+ = q exp(h D),   D = v + (1/2 - beta) h a + beta h a+ - M^{-1} C(q)^T eta,
//   v+ = v + (1 - gamma) h a + gamma h a+,
//   (1 - alpha_m) a+ + alpha_m a = (1 - alpha_f) v'+ + alpha_f v',
//   M v'+ + C^T lambda+ = Q,   Phi(q+) = 0,   C(q+) v+ + b = 0,
// with alpha_m = (2 rho - 1)/(rho + 1), alpha_f = rho/(rho + 1), gamma = 1/2 + alpha_f - alpha_m and
// beta = (gamma + 1/2)^2 / 4 [chunghulbert1993]. Option `rho`: spectral radius at infinite frequency; 0 damps most, and
// with 1 the multipliers are undamped and do not converge.
// The auxiliary a is v' at t + (alpha_m - alpha_f) h. So it starts as v'(0) + (alpha_m - alpha_f) h v''(0); any other
// start costs an order in the first steps [arnold2016]. v'' is the central difference of the index-1 v' along the flow
// over h/8: its error is O(h^2), its round-off in a stays some eps v'. A change of h starts the method afresh.
#include "mechanics/system.hpp"
#include "methods/contract/integrator.hpp"
#include "methods/implicit/stabilised_step.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

class GeneralisedAlpha final : public Integrator {
  public:
    GeneralisedAlpha(System& system, const Real& rho)
        : system_(system),
          alpha_m_((2 * rho - 1) / (rho + 1)),
          alpha_f_(rho / (rho + 1)),
          gamma_(Real(1) / 2 + alpha_f_ - alpha_m_),
          beta_((gamma_ + Real(1) / 2) * (gamma_ + Real(1) / 2) / 4),
          step_(system),
          a_(VecX::Zero(system.velocities())),
          a_known_(a_),
          rate_(a_),
          near_rate_(a_),
          shift_(a_),
          near_(static_cast<std::size_t>(system.state_group().size())) {}

    Status start(const Real&, const Real*) override {
        h_ = 0;
        return Status::ok;
    }

    Status step(const Real& t, const Real& h, Real* y) override {
        if (h == 0) return system_.evaluate(t, y, system_.v(y), near_rate_.data());
        if (h != h_)
            if (const Status status = begin(t, h, y); status != Status::ok) return status;
        h_ = 0;  // until this step has succeeded
        set_relations(system_.v(y));
        const Status status = step_.advance(t, h, y);
        work_.newton_iterations = step_.iterations();
        if (status != Status::ok) return status;
        a_ = a_known_ + a_slope() * step_.rate();
        h_ = h, stepped_ = true;
        return Status::ok;
    }

    const Real* multipliers() const override { return stepped_ ? step_.multipliers() : nullptr; }

  private:
    /// d a+ / d v'+.
    Real a_slope() const { return (1 - alpha_f_) / (1 - alpha_m_); }

    /// h a at the start.
    Status begin(const Real& t, const Real& h, const Real* y) {
        stepped_ = false;
        if (const Status status = step_.start(t, h, y); status != Status::ok) return status;
        rate_ = step_.rate();
        const Real near = Real(1) / 8;  // in units of h
        a_ = rate_;
        for (const int side : {1, -1}) {
            if (const Status status = rate_along_flow(t, h, side * near, y); status != Status::ok) return status;
            a_ += (alpha_m_ - alpha_f_) * side / (2 * near) * near_rate_;
        }
        return Status::ok;
    }

    /// near_rate_ = h v' at t + d h on the flow through y, up to O(d^3 h^3) in q and O(d^2 h^2) in v (even in d).
    Status rate_along_flow(const Real& t, const Real& h, const Real& d, const Real* y) {
        const Real* v = system_.v(y);
        Real* near_v = system_.v(near_.data());
        for (Eigen::Index i = 0; i < shift_.size(); ++i) {
            shift_[i] = d * h * (v[i] + d * rate_[i] / 2);
            near_v[i] = v[i] + d * rate_[i];
        }
        system_.group().append_exp(y, shift_.data(), near_.data());
        const Status status = system_.evaluate(t + d * h, near_.data(), near_v, near_rate_.data());
        near_rate_ *= h;
        return status;
    }

    /// v+ and D as functions of h v'+.
    void set_relations(const Real* v_now) {
        const Eigen::Map<const VecX> v(v_now, a_.size());
        a_known_ = (alpha_f_ * step_.rate() - alpha_m_ * a_) / (1 - alpha_m_);
        step_.velocity_slope = gamma_ * a_slope();
        step_.velocity_offset = v + (1 - gamma_) * a_ + gamma_ * a_known_;
        step_.increment_slope = beta_ * a_slope();
        step_.increment_offset = v + (Real(1) / 2 - beta_) * a_ + beta_ * a_known_;
    }

    System& system_;
    Real alpha_m_, alpha_f_, gamma_, beta_;
    StabilisedStep step_;
    VecX a_, a_known_, rate_, near_rate_, shift_;  // a times h; the part of h a+ that is known; h v'
    std::vector<Real> near_;
    Real h_ = 0;  // step that the memory belongs to; 0: none
    bool stepped_ = false;
};

Factory generalised_alpha() {
    Factory factory;
    factory.make = [](System& system, const OptionValues& options, const MethodDescription&) {
        return std::make_unique<GeneralisedAlpha>(system, decimal(std::get<double>(options.at("rho"))));
    };
    factory.options = {{.name = "rho",
                        .summary = "spectral radius at infinite frequency, below 1: 0 damps most",
                        .standard = 9.0 / 10,
                        .real_min = 0,
                        .real_max = 1}};
    factory.why_not = [](const OptionValues& options) -> std::string {
        return std::get<double>(options.at("rho")) < 1
                   ? ""
                   : "with rho = 1 nothing damps the multipliers: they do not converge";
    };
    return factory;
}

}  // namespace

KREISEL_METHOD(generalised_alpha(), {.name = "generalized_alpha/index2",
                                     .order = 2,
                                     .cites = {"bruels2012", "arnold2016", "chunghulbert1993", "gear1985"},
                                     .summary = "generalised-alpha method on Lie groups, stabilised index-2 form",
                                     .variable_cost = true,
                                     .form = Form::implicit,
                                     .reports_multipliers = true,
                                     .meets_positions = true,
                                     .meets_velocities = true,
                                     .keeps_memory = true,
                                     .preserves = {{Property::constraints, Domain::autonomous}}});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
