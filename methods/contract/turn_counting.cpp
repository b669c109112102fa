// SPDX-License-Identifier: BSD-3-Clause
#include "methods/contract/turn_counting.hpp"

#include <algorithm>

#include "mechanics/step_watcher.hpp"
#include "mechanics/system.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// Tells a system where the steps of a method begin and end, so that its torsion springs count full turns, and
/// equations that depend on the step size know it.
class TurnCounting final : public Integrator {
  public:
    TurnCounting(System& system, std::unique_ptr<Integrator> method)
        : system_(system), method_(std::move(method)), before_(static_cast<std::size_t>(system.state_group().size())) {}

    Status start(const Real& t, const Real* y) override { return method_->start(t, y); }

    Status step(const Real& t, const Real& h, Real* y) override {
        std::copy_n(y, before_.size(), before_.begin());
        Status status = system_.begin_step(t, h, y);
        const bool begun = status == Status::ok;
        if (begun) status = method_->step(t, h, y);
        const bool moved = begun && status == Status::ok;
        status = system_.end_step(status, t + h, y);
        if (status == Status::ok) return status;
        std::copy(before_.begin(), before_.end(), y);
        if (moved) method_->start(t, y);  // its memory is of a rejected step
        return status;
    }

    Status attempt(const Real& t, const Real& h, const Real* y, Real* y_new, Real* error) override {
        Status status = system_.begin_step(t, h, y);
        if (status == Status::ok) status = method_->attempt(t, h, y, y_new, error);
        return system_.end_step(status, t + h, y_new);
    }
    void accept(bool moved) override { method_->accept(moved); }
    void interpolate(const Real& theta, const Real& h, const Real* y0, Real* y) override {
        method_->interpolate(theta, h, y0, y);
    }

    const Real* multipliers() const override { return method_->multipliers(); }
    const Work& work() const override { return method_->work(); }

  private:
    System& system_;
    std::unique_ptr<Integrator> method_;
    std::vector<Real> before_;
};

}  // namespace

std::unique_ptr<Integrator> counting_turns(System& system, std::unique_ptr<Integrator> method) {
    if (system.torsion_springs() == 0 && !dynamic_cast<const StepWatcher*>(&system)) return method;
    return std::make_unique<TurnCounting>(system, std::move(method));
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
