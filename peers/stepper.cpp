// SPDX-License-Identifier: BSD-3-Clause
#include "peers/stepper.hpp"

#include <algorithm>

#include "mechanics/system.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

PeerStepper::PeerStepper(System& system, Projection& projection, const Accuracy& accuracy,
                         const MethodDescription& description, int first_order)
    : equations_(system, accuracy),
      unknowns_(equations_.size()),
      tolerance_(accuracy.tolerance),
      system_(system),
      projection_(projection),
      name_(description.name),
      first_(pow(Real(accuracy.tolerance / 100), Real(Real(1) / first_order))),
      new_(static_cast<std::size_t>(system.state_group().size())),
      unprojected_(new_) {}

Status PeerStepper::start(const Real& t, const Real& t_end, const Real* y) {
    projection_.start();
    return begin_run(t, t_end, y);
}

Status PeerStepper::begin_run(const Real& t, const Real& t_end, const Real* y) {
    t_end_ = t_end, stale_ = in_projection_ = false;
    const Real span = t_end - t;
    least_ = epsilon * abs(span);
    if (const Status status = equations_.start(t, span, y, unknowns_.data()); status != Status::ok) return status;
    const Real& rate = equations_.rate();
    const Real size = rate > 0 ? min(Real(abs(span)), Real(first_ / rate)) : Real(abs(span));
    h_ = span < 0 ? -size : size;
    return begin(t);
}

Status PeerStepper::step(Real& t, const Real& limit, Real* y) {
    if (stale_)
        if (const Status status = begin_run(t, t_end_, y); status != Status::ok) return status;
    in_projection_ = false;
    std::copy_n(y, new_.size(), new_.begin());  // its labels
    Real end = t;
    // The length of the step is the library's affair: 0 stands for it. An angle that is not where its rate leads is a
    // status of the equations of motion, upon which the library tries a shorter step.
    Status status = system_.begin_step(t, 0, y);
    if (status == Status::ok) status = move(end, limit);
    status = system_.end_step(status, end, new_.data());
    if (status == Status::ok) status = project(end);
    stale_ = status != Status::ok;
    if (stale_ && in_projection_) projection_.retract();
    if (stale_) return status;
    std::copy(new_.begin(), new_.end(), y);
    t = end;
    ++accepted_;
    return Status::ok;
}

Status PeerStepper::move(Real& t, const Real& limit) {
    equations_.forget();
    if (const Status status = advance(t, limit); status != Status::ok) return status;
    equations_.write(unknowns_.data(), new_.data());
    Real sum = 0;
    for (const Real& x : new_) sum += x;
    return isfinite(sum) ? Status::ok : Status::non_finite;
}

Status PeerStepper::project(const Real& t) {
    unprojected_ = new_;
    in_projection_ = true;
    if (const Status status = projection_.project(t, new_.data()); status != Status::ok) return status;
    if (new_ == unprojected_) return Status::ok;
    equations_.read(new_.data(), unknowns_.data());
    return resume(t);
}

std::string PeerStepper::failed_part() const {
    return in_projection_ ? "projection after a step of " + name_ : "step of " + name_;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
