// SPDX-License-Identifier: BSD-3-Clause
//
// Controlled steppers of Boost.Odeint [ahnert2011], which know the norm of built-in numbers only. They accept NaN as a
// success and enlarge the step, so that what they accept is checked here; a rejection that does not shorten the step,
// which Bulirsch-Stoer may repeat for ever, is shortened here. Bulirsch-Stoer allocates in each step.
#pragma once

#include <algorithm>
#include <boost/numeric/odeint/stepper/controlled_step_result.hpp>
#include <functional>
#include <optional>

#include "methods/control/fitted_step.hpp"
#include "peers/stepper.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

using OdeintState = std::vector<Real>;

/// `Controlled`: a controlled stepper of Odeint on OdeintState.
template <class Controlled>
class OdeintStepper final : public PeerStepper {
  public:
    /// A stepper to an absolute tolerance.
    using Make = std::function<Controlled(const Real& tolerance)>;

    OdeintStepper(System& system, Projection& projection, const Accuracy& accuracy,
                  const MethodDescription& description, int first_order, Make make)
        : PeerStepper(system, projection, accuracy, description, first_order),
          make_(std::move(make)),
          before_(unknowns_) {}

  protected:
    Status begin(const Real&) override {
        controlled_.emplace(make_(tolerance_));
        return Status::ok;
    }
    /// Drops the slope that is the first one of the next step, where there is one.
    Status resume(const Real&) override {
        if constexpr (requires { controlled_->reset(); }) controlled_->reset();
        return Status::ok;
    }

    Status advance(Real& t, const Real& limit) override {
        for (;;) {
            const FittedStep fitted = fit(t, h_, limit);
            if (t + fitted.h == t || lost()) return equations_.status(Status::step_too_small);
            Real next = fitted.h;
            if (attempt(t, next)) {
                // A step cut short at a limit says little of longer ones.
                if (!fitted.shortened || abs(next) > abs(h_)) h_ = next;
                t = fitted.end;
                return Status::ok;
            }
            ++rejected_;
            h_ = abs(next) < abs(fitted.h) ? next : Real(fitted.h / 2);  // also where next is NaN
        }
    }

  private:
    /// One step by h, which becomes the proposal for the next. Where it is rejected the unknowns stay.
    bool attempt(const Real& t, Real& h) {
        equations_.forget();
        before_ = unknowns_;
        const Real proposed = h;
        Real time = t;
        const auto derivative = [this](const OdeintState& u, OdeintState& du, const Real& s) {
            equations_.derivative(s, u.data(), du.data());
        };
        const bool accepted = controlled_->try_step(derivative, unknowns_, time, h) == boost::numeric::odeint::success;
        if (equations_.status() == Status::ok && isfinite(h)) return accepted;
        // NaN has been met, and may be remembered.
        unknowns_ = before_;
        controlled_.emplace(make_(tolerance_));
        h = proposed / 4;
        return false;
    }

    Make make_;
    std::optional<Controlled> controlled_;
    OdeintState before_;
};

/// `stages`: solves of the dynamics per attempt, where their number is fixed.
template <class Controlled>
Factory odeint(typename OdeintStepper<Controlled>::Make make, int stages, int first_order) {
    Factory factory;
    factory.stages = stages;
    factory.stepper = [make, first_order](System& system, Projection& projection, const Accuracy& accuracy,
                                          const OptionValues&, const MethodDescription& description) {
        return std::make_unique<OdeintStepper<Controlled>>(system, projection, accuracy, description, first_order,
                                                           make);
    };
    return factory;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
