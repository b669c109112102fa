// SPDX-License-Identifier: BSD-3-Clause
#include "methods/extrapolation/gbs_stepper.hpp"

#include <algorithm>

#include "mechanics/system.hpp"
#include "methods/control/first_step.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

constexpr int max_columns = KREISEL_QUAD ? 16 : 9;

}  // namespace

GbsStepper::GbsStepper(System& system, Projection& projection, const MakeExtrapolationBase& base,
                       const Accuracy& accuracy, std::string name)
    : system_(system),
      projection_(projection, static_cast<std::size_t>(system.state_group().size())),
      base_(base(system, work_)),
      table_(max_columns, system.state_group().dim()),
      control_(max_columns),
      norm_(system, accuracy),
      tolerance_(accuracy.tolerance),
      name_(std::move(name)),
      new_(static_cast<std::size_t>(system.state_group().size())),
      slope_(static_cast<std::size_t>(system.state_group().dim())) {}

Status GbsStepper::start(const Real& t, const Real& t_end, const Real* y) {
    first_known_ = in_projection_ = false;
    projection_.start();
    if (t_end == t) return Status::ok;
    const int aim = OrderAndStep::first_aim(tolerance_, max_columns);
    Real h = 0;
    const Status status = guess_first_step(system_, norm_, tolerance_, 2 * aim - 1, t, t_end, y, slope_.data(), h);
    if (status == Status::ok) control_.start(aim, h);
    return status;
}

Status GbsStepper::step(Real& t, const Real& limit, Real* y) {
    Status last = Status::step_too_small;
    for (;;) {
        const FittedStep fitted = fit(t, control_.step(), limit);
        if (is_too_small(fitted, t, limit)) return last;
        control_.begin(fitted.h, fitted.shortened);
        int line = 1;
        bool converged = false;
        const Status status = attempt(t, fitted, y, line, converged);
        if (status == Status::ok && converged) {
            std::copy(new_.begin(), new_.end(), y);
            t = fitted.end;
            control_.accepted(line);
            projection_.accept();
            first_known_ = false;
            ++accepted_;
            return Status::ok;
        }
        ++rejected_;
        control_.rejected(status == Status::ok ? line : 1);
        last = status == Status::ok ? Status::step_too_small : status;
    }
}

Status GbsStepper::attempt(const Real& t, const FittedStep& fitted, const Real* y, int& line, bool& converged) {
    in_projection_ = false;
    if (system_.torsion_springs() == 0) return lines(t, fitted, y, line, converged);
    Status status = system_.begin_step(t, fitted.h, y);
    if (status == Status::ok) status = lines(t, fitted, y, line, converged);
    if (status == Status::ok && converged) return system_.end_step(status, fitted.end, new_.data());
    system_.end_step(Status::step_too_small, fitted.end, new_.data());
    return status;
}

Status GbsStepper::lines(const Real& t, const FittedStep& fitted, const Real* y, int& line, bool& converged) {
    if (const Status status = base_->begin(t, fitted.h, y, first_known_); status != Status::ok) return status;
    first_known_ = true;
    for (line = 1; line <= control_.last_line(); ++line) {
        if (const Status status = base_->row(substeps(line), table_.row(line)); status != Status::ok) return status;
        table_.extrapolate(line);
        if (line == 1) continue;
        Real error = error_of_line(fitted.h, y);
        if (!isfinite(error)) return Status::non_finite;
        auto verdict = control_.judge(line, error);
        if (verdict == OrderAndStep::Verdict::accept) {
            in_projection_ = true;
            const Status status = projection_.apply(fitted.h, fitted.end, norm_, new_.data(), error);
            if (status != Status::ok) return status;
            in_projection_ = false;
            verdict = control_.judge(line, error);
        }
        converged = verdict == OrderAndStep::Verdict::accept;
        if (verdict != OrderAndStep::Verdict::next_line) return Status::ok;
    }
    return Status::ok;
}

Real GbsStepper::error_of_line(const Real& H, const Real* y) {
    base_->state(table_.result(), new_.data());
    return norm_(H, y, new_.data(), table_.difference());
}

std::string GbsStepper::failed_part() const {
    return in_projection_ ? "projection after a step of " + name_ : "step of " + name_;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
