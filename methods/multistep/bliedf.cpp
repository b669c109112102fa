// SPDX-License-Identifier: BSD-3-Clause
#include "methods/multistep/bliedf.hpp"

#include <array>

#include "mechanics/system.hpp"
#include "methods/contract/integrator.hpp"
#include "methods/implicit/position_step.hpp"
#include "methods/implicit/stabilised_step.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

constexpr int most_steps = 3;

/// alpha and gamma as whole numbers over `whole`.
struct Formula {
    int whole;
    std::array<int, most_steps + 1> alpha;
    std::array<int, most_steps> gamma;
};

constexpr std::array<Formula, most_steps> formulas = {
    {{1, {1, -1}, {1}}, {2, {3, -4, 1}, {3, -1}}, {6, {11, -18, 9, -2}, {11, -7, 2}}}};

std::unique_ptr<Integrator> bind_standard(const Method& method, System& system) {
    return method.factory.make(system, with_defaults({}, method.description.options), method.description);
}

/// With the constraints of the form that `Step` solves.
template <class Step>
class BLieDF final : public Integrator {
  public:
    BLieDF(System& system, int k)
        : system_(system),
          k_(static_cast<std::size_t>(k)),
          formula_(formulas[k_ - 1]),
          step_(system),
          starter_(bind_standard(method("rkmk/rk4"), system)),
          bracket_(VecX::Zero(system.velocities())),
          state_(static_cast<std::size_t>(system.state_group().size())),
          earlier_(state_),
          past_(state_) {
        velocities_.fill(bracket_), increments_.fill(bracket_);
    }

    Status start(const Real&, const Real*) override {
        h_ = 0;
        return Status::ok;
    }

    Status step(const Real& t, const Real& h, Real* y) override {
        if (h == 0) return system_.evaluate(t, y, system_.v(y), bracket_.data());
        if (h != h_)
            if (const Status status = begin(t, h, y); status != Status::ok) return status;
        h_ = 0;  // until this step has succeeded
        velocities_[0] = Eigen::Map<const VecX>(system_.v(y), bracket_.size());
        set_relations(h);
        const Status status = step_.advance(t, h, y);
        work_.newton_iterations = step_.iterations();
        if (status != Status::ok) return status;
        increments_[0] = step_.increment();
        if (k_ == most_steps) increments_[0] -= bracket_;
        for (std::size_t i = k_ - 1; i > 0; --i) {
            velocities_[i].swap(velocities_[i - 1]);
            increments_[i].swap(increments_[i - 1]);
        }
        h_ = h, stepped_ = true;
        return Status::ok;
    }

    const Real* multipliers() const override { return stepped_ ? step_.multipliers() : nullptr; }

  private:
    /// The k - 1 steps that would have led to y.
    Status begin(const Real& t, const Real& h, const Real* y) {
        stepped_ = false;
        if (const Status status = step_.start(t, h, y); status != Status::ok) return status;
        std::copy_n(y, state_.size(), state_.begin());
        set_bracket(h, system_.v(y));
        for (std::size_t i = 1; i < k_; ++i) {
            earlier_ = state_;
            const Status status = starter_->step(t - static_cast<int>(i - 1) * h, -h, earlier_.data());
            // A motion that runs away within such steps has none forwards either.
            const bool runs_away = status == Status::non_finite || status == Status::left_chart;
            if (status != Status::ok) return runs_away ? Status::newton_failed : status;
            velocities_[i] = Eigen::Map<const VecX>(system_.v(earlier_.data()), bracket_.size());
            set_increment(h, increments_[i]);
            state_ = earlier_;
        }
        return Status::ok;
    }

    /// Delta of the step from earlier_ to state_, log(earlier^{-1} state) / h - h^2/12 [v, v'].
    void set_increment(const Real& h, VecX& increment) {
        const Group& group = system_.group();
        std::copy(earlier_.begin(), earlier_.end(), past_.begin());
        group.inverse(past_.data(), past_.data());
        group.multiply(past_.data(), state_.data(), past_.data());
        group.log(past_.data(), increment.data());
        increment /= h;
        if (k_ == most_steps) increment -= bracket_;
    }

    /// h^2/12 [v, v'].
    void set_bracket(const Real& h, const Real* v) {
        system_.group().bracket(v, step_.rate().data(), bracket_.data());
        bracket_ *= h / 12;
    }

    /// v+ and D as functions of h v'+.
    void set_relations(const Real& h) {
        const auto& [whole, alpha, gamma] = formula_;
        step_.velocity_slope = Real(whole) / alpha[0];
        step_.velocity_offset = -alpha[1] * velocities_[0];
        for (std::size_t i = 1; i < k_; ++i) step_.velocity_offset -= alpha[i + 1] * velocities_[i];
        step_.velocity_offset /= alpha[0];
        step_.increment_slope = Real(whole * whole) / (alpha[0] * gamma[0]);
        step_.increment_offset = whole * step_.velocity_offset;
        for (std::size_t i = 1; i < k_; ++i) step_.increment_offset -= gamma[i] * increments_[i];
        step_.increment_offset /= gamma[0];
        if (k_ < most_steps) return;
        set_bracket(h, velocities_[0].data());
        step_.increment_offset += bracket_;
    }

    System& system_;
    std::size_t k_;
    Formula formula_;
    Step step_;
    std::unique_ptr<Integrator> starter_;
    std::array<VecX, most_steps> velocities_, increments_;  // v_n, v_{n-1}, ...; Delta_n, Delta_{n-1}, ...
    VecX bracket_;                                          // h^2/12 [v, v'] of the last step
    std::vector<Real> state_, earlier_, past_;
    Real h_ = 0;  // step that the memory belongs to; 0: none
    bool stepped_ = false;
};

template <class Step>
Factory bliedf_of(int k) {
    Factory factory;
    factory.make = [k](System& system, const OptionValues&, const MethodDescription&) {
        return std::make_unique<BLieDF<Step>>(system, k);
    };
    return factory;
}

}  // namespace

Factory bliedf(int k) { return bliedf_of<StabilisedStep>(k); }

Factory bliedf_index3(int k) { return bliedf_of<PositionStep>(k); }

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
