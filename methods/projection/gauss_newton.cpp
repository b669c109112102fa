// SPDX-License-Identifier: BSD-3-Clause
#include "methods/projection/gauss_newton.hpp"

#include <limits>
#include <utility>

#include "methods/projection/least_corrections.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

constexpr int most_gauss_newton_steps = 25;

/// A row is at round-off below this fraction of its terms. Iterations that no longer halve the largest row have
/// converged too, if it is at most `stagnation` of the round-off of places; otherwise they have failed.
const Real round_off = 4 * epsilon, stagnation = 1000 * round_off;

}  // namespace

GaussNewtonProjection::GaussNewtonProjection(System& system, ProjectedLevels levels, bool once,
                                             std::unique_ptr<Correction> correction)
    : system_(system),
      levels_(levels),
      once_(once),
      correction_(std::move(correction)),
      residual_(static_cast<std::size_t>(system.constraints())),
      terms_(static_cast<std::size_t>(system.position_constraints())),
      scale_(residual_.size()),
      delta_(static_cast<std::size_t>(system.velocities())) {
    system.row_scale(scale_.data());
}

Status GaussNewtonProjection::project(const Real& t, Real* y) {
    Status status = Status::ok;
    if (levels_.positions) status = project_position(t, y);
    return status == Status::ok && levels_.velocities ? project_velocity(t, y) : status;
}

/// The largest position row relative to its terms, NaN where one is not finite; the rows change their sign.
Real GaussNewtonProjection::turn_residual() {
    Real largest = 0, sum = 0;
    Real *r = residual_.data(), *const end = r + terms_.size();
    for (const Real* terms = terms_.data(); r != end; ++r, ++terms) {
        const Real value = *r;
        sum += value;
        if (value != 0) largest = max(largest, Real(abs(value) / *terms));
        *r = -value;
    }
    return isfinite(sum) ? largest : std::numeric_limits<Real>::quiet_NaN();
}

/// Where the mechanism is far from the origin, a redundant row is known only as well as the others, relative to their
/// scales; this includes rows that compare directions.
bool GaussNewtonProjection::stands_still() const {
    Real remoteness = 1;
    for (std::size_t i = 0; i < terms_.size(); ++i) remoteness = max(remoteness, Real(terms_[i] / scale_[i]));
    for (std::size_t i = 0; i < terms_.size(); ++i)
        if (!(abs(residual_[i]) <= stagnation * max(terms_[i], Real(remoteness * scale_[i])))) return false;
    return true;
}

/// A delta with C delta = residual_.
Status GaussNewtonProjection::solve(const Real& t, const Real* q) {
    ++iterations_;
    return correction_->solve(t, q, residual_.data(), delta_.data());
}

Status GaussNewtonProjection::project_position(const Real& t, Real* y) {
    if (residual_.empty()) return Status::ok;
    system_.position_scale(y, terms_.data());
    Real previous = std::numeric_limits<Real>::max();
    for (int i = 0; i < most_gauss_newton_steps; ++i) {
        system_.position_residual(t, y, residual_.data());
        const Real size = turn_residual();
        if (!isfinite(size)) return Status::non_finite;
        if (size <= round_off || (2 * size > previous && stands_still())) return Status::ok;
        previous = size;
        for (std::size_t k = terms_.size(); k < residual_.size(); ++k) residual_[k] = 0;
        if (const Status status = solve(t, y); status != Status::ok) return status;
        system_.group().append_exp(y, delta_.data(), y);
        if (once_) return Status::ok;
    }
    return Status::projection_failed;
}

Status GaussNewtonProjection::project_velocity(const Real& t, Real* y) {
    if (residual_.empty()) return Status::ok;
    Real* v = system_.v(y);
    system_.velocity_residual(t, y, v, residual_.data());
    Real sum = 0;
    for (const Real& r : residual_) sum += r;
    if (!isfinite(sum)) return Status::non_finite;
    if (const Status status = solve(t, y); status != Status::ok) return status;
    KREISEL_ELEMENTWISE
    for (std::size_t i = 0; i < delta_.size(); ++i) v[i] -= delta_[i];
    return Status::ok;
}

OptionDescription iterations_option() {
    return {.name = "iterations",
            .summary = "converged, or one: positions stay off their constraints by the square of what they were off",
            .standard = "converged",
            .choices = {"converged", "one"}};
}

bool is_once(const OptionValues& options) {
    const auto found = options.find("iterations");
    return found != options.end() && std::get<std::string>(found->second) == "one";
}

std::vector<OptionDescription> least_projection_options(ProjectedLevels levels) {
    std::vector<OptionDescription> options = {
        {.name = "weight",
         .summary = "metric of the least correction: mass, or identity, which counts metres and radians alike",
         .standard = "mass",
         .choices = {"mass", "identity"}}};
    if (levels.positions) options.push_back(iterations_option());
    return options;
}

MakeProjection least_projection(ProjectedLevels levels) {
    return [levels](System& system, const OptionValues& options) {
        const bool mass = std::get<std::string>(options.at("weight")) == "mass";
        return std::make_unique<GaussNewtonProjection>(system, levels, is_once(options),
                                                       mass ? least_in_mass(system) : least_in_coordinates(system));
    };
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
