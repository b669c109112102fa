// SPDX-License-Identifier: BSD-3-Clause
#include "methods/control/step_control.hpp"

#include <algorithm>
#include <limits>

#include "methods/control/first_step.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

const Real no_limit = std::numeric_limits<Real>::infinity();

}  // namespace

StepControl::StepControl(System& system, Projection& projection, std::unique_ptr<Integrator> method,
                         const Accuracy& accuracy, const MethodDescription& description)
    : system_(system),
      method_(std::move(method)),
      projection_(projection, static_cast<std::size_t>(system.state_group().size())),
      norm_(system, accuracy),
      controller_(accuracy.controller, description.estimate),
      tolerance_(accuracy.tolerance),
      estimate_(description.estimate),
      name_(description.name),
      new_(static_cast<std::size_t>(system.state_group().size())),
      error_(static_cast<std::size_t>(system.state_group().dim())) {}

Status StepControl::start(const Real& t, const Real& t_end, const Real* y) {
    h_ = 0, in_projection_ = false;
    controller_.start();
    projection_.start();
    if (const Status status = method_->start(t, y); status != Status::ok) return status;
    if (t_end == t) return Status::ok;
    return guess_first_step(system_, norm_, tolerance_, estimate_, t, t_end, y, error_.data(), h_);
}

Status StepControl::step(Real& t, const Real& limit, Real* y) {
    Status last = Status::step_too_small;
    for (;;) {
        const FittedStep fitted = fit(t, h_, limit);
        if (is_too_small(fitted, t, limit)) return last;
        Real error = 0;
        const Status status = attempt(t, fitted.h, fitted.end, y, error);
        if (status == Status::ok && error <= 1) {
            accept(fitted, error, y);
            t = fitted.end;
            return Status::ok;
        }
        ++rejected_;
        last = status == Status::ok ? Status::step_too_small : status;
        h_ = fitted.h * controller_.after_rejection(status == Status::ok ? error : no_limit);
    }
}

Status StepControl::attempt(const Real& t, const Real& h, const Real& end, const Real* y, Real& error) {
    in_projection_ = false;
    if (const Status status = method_->attempt(t, h, y, new_.data(), error_.data()); status != Status::ok)
        return status;
    error = norm_(h, y, new_.data(), error_.data());
    if (!isfinite(error)) return Status::non_finite;
    if (error > 1) return Status::ok;
    in_projection_ = true;
    return projection_.apply(h, end, norm_, new_.data(), error);
}

void StepControl::accept(const FittedStep& fitted, const Real& error, Real* y) {
    std::copy(new_.begin(), new_.end(), y);
    method_->accept(projection_.moved());
    projection_.accept();
    ++accepted_;
    const Real next = fitted.h * controller_.after_acceptance(fitted.h, error);
    // A step cut short at a limit says little of longer ones.
    if (!fitted.shortened || abs(next) > abs(h_)) h_ = next;
}

std::string StepControl::failed_part() const {
    return in_projection_ ? "projection after a step of " + name_ : "step of " + name_;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
