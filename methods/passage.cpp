// SPDX-License-Identifier: BSD-3-Clause
#include "methods/passage.hpp"

#include <algorithm>
#include <sstream>

#include "mechanics/model/scales.hpp"
#include "mechanics/solve/forest.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

// Measured on a parallelogram through its flat poses: 1e-13 to 1e-10 with projection; where the distance was 1e-6,
// velocities were wrong by some 1e-5 afterwards.
const Real most_distance = Real(1) / 1000000, least_pivot = Real(1) / 1000;

}  // namespace

bool SingularPassage::is_possible(const Model& model) { return !model.joints.empty() && !is_forest(model); }

SingularPassage::SingularPassage(System& system, const Model& model, std::unique_ptr<Projection> projection)
    : system_(system),
      pivots_(dynamic_cast<PivotRecord*>(&system)),
      projection_(std::move(projection)),
      extent_(extent(model)),
      residual_(static_cast<std::size_t>(system.constraints())),
      scale_(residual_.size()),
      states_(model.bodies.size()) {
    system.row_scale(scale_.data());
    for (std::size_t i = 0; i < model.joints.size(); ++i) joints_.push_back(model.name_of_joint(i));
}

Status SingularPassage::project(const Real& t, Real* y) {
    reason_.clear();
    const long before = projection_->iterations();
    const Status status = projection_->project(t, y);
    iterations_ += projection_->iterations() - before;
    return status == Status::ok && pivots_ ? check(t, y) : status;
}

Real SingularPassage::rate(const Real* y) {
    system_.read(y, states_.data());
    Real largest = 0;
    for (const BodyState& s : states_) largest = max(largest, max(Real(s.omega.norm()), Real(s.v.norm() / extent_)));
    return largest;
}

std::pair<Real, std::size_t> SingularPassage::worst(const Real& unit) const {
    std::pair<Real, std::size_t> found{0, 0};
    for (std::size_t i = 0; i < residual_.size(); ++i) {
        const Real size = abs(residual_[i]) / (scale_[i] * unit);
        if (size > found.first) found = {size, i};
    }
    return found;
}

Status SingularPassage::check(const Real& t, const Real* y) {
    const Real now = pivots_->least_pivot();
    if (!(first_ > 0)) first_ = now;
    const Real pivot = max(Real(now / first_), Real(epsilon * epsilon));  // none where a row has no pivot left
    if (!(pivot < least_pivot)) return Status::ok;
    std::fill(residual_.begin(), residual_.end(), Real(0));  // rows without a position level
    system_.position_residual(t, y, residual_.data());
    std::pair<Real, std::size_t> found = worst(1);
    if (const Real unit = rate(y); unit > 0) {
        system_.velocity_residual(t, y, system_.v(y), residual_.data());
        const auto moving = worst(unit);
        if (moving.first > found.first) found = moving;
    }
    const Real distance = found.first / sqrt(pivot);
    if (!(distance > most_distance)) return Status::ok;
    std::ostringstream text;
    text.precision(2);
    text << "beside a pose in which the constraints lose rank (pivots " << to_double(pivot)
         << " of those at the start) the state is " << to_double(distance)
         << " off them, relative to their scale and rate, most at "
         << joints_.at(static_cast<std::size_t>(system_.constraint_rows()[found.second].joint))
         << ": how it goes on is not determined; projection position_velocity keeps it on them";
    reason_ = text.str();
    return Status::singular_kkt;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
