// SPDX-License-Identifier: BSD-3-Clause
#include "methods/control/controller.hpp"

#include <stdexcept>

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

const Real safety = Real(9) / 10, least_factor = Real(1) / 5, largest_factor = 5;
/// An error of zero, or nearly so, would ask for an infinite step.
const Real least_error = Real(1) / 10000;

Real within(const Real& factor) { return min(largest_factor, max(least_factor, factor)); }

}  // namespace

StepSizeController::Law StepSizeController::law_of(const std::string& name) {
    if (name == "elementary") return Law::elementary;
    if (name == "pi") return Law::pi;
    if (name == "pid") return Law::pid;
    throw std::invalid_argument("expected a controller (elementary, pi, pid), got \"" + name + "\"");
}

StepSizeController::StepSizeController(const std::string& name, int estimate) : law_(law_of(name)), r_(estimate) {}

Real StepSizeController::elementary(const Real& error) const { return safety * pow(error, Real(-1 / r_)); }

Real StepSizeController::factor(const Real& h, const Real& error) const {
    if (law_ == Law::elementary || known_ == 0) return elementary(error);
    if (law_ == Law::pi) return safety * pow(error, Real(-7 / (10 * r_))) * pow(error_before_, Real(4 / (10 * r_)));
    return safety * pow(error * error_before_, Real(-1 / (4 * r_))) * pow(abs(h / h_before_), Real(-1) / 4);
}

Real StepSizeController::after_acceptance(const Real& h, const Real& error) {
    const Real e = max(error, least_error);
    Real next = within(factor(h, e));
    if (rejected_) next = min(next, Real(1));
    error_before_ = e, h_before_ = h, ++known_, rejected_ = false;
    return next;
}

Real StepSizeController::after_rejection(const Real& error) {
    rejected_ = true;
    if (!isfinite(error)) return Real(1) / 4;
    return max(least_factor, min(safety, elementary(error)));
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
