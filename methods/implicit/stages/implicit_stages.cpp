// SPDX-License-Identifier: BSD-3-Clause
#include "methods/implicit/stages/implicit_stages.hpp"

#include <utility>

#include "mechanics/actions/acted_upon.hpp"
#include "methods/implicit/stages/acted_stages.hpp"
#include "methods/implicit/stages/tangent_stages.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

ImplicitStages::ImplicitStages(System& system, StageCoefficients coefficients, StageCentre centre)
    : system_(system),
      coefficients_(std::move(coefficients)),
      around_middle_(centre == StageCentre::middle),
      n_(system.velocities()),
      stages_(coefficients_.b.size()),
      k_(MatX::Zero(n_, stages_)),
      w_(k_),
      f_(k_),
      difference_(VecX::Zero(n_)),
      newton_(2 * n_ * stages_),
      scale_(system),
      remoteness_of_(system),
      past_(2 * n_ * stages_),
      turned_(VecX::Zero(2 * n_ * stages_)),
      weights_(VecX::Ones(turned_.size())),
      rate_(difference_) {}

Status ImplicitStages::advance(const Real& t, const Real& h, Real* y) {
    t_ = t, h_ = h, y_ = y;
    scale_.weigh(y);
    if (const Status status = guess(); status != Status::ok) return status;
    motion_ = scale_.of_motion(t, h, y);
    remoteness_ = remoteness_of_.measure(y);
    if (const Status status = iterate(); status != Status::ok) {
        past_.clear();
        return status;
    }
    past_.push(turned_);
    accept(y);
    return Status::ok;
}

/// From the steps before, or from constant v' and f at the start and where something is stiff.
Status ImplicitStages::guess() {
    if (h_ != known_h_) newton_.forget(), past_.clear();
    known_h_ = h_;
    if (!past_.empty() && !newton_.stiff()) {
        past_.guess(past_.best_degree(turned_.size()), turned_);
        return Status::ok;
    }
    const Status status = slope_at_start(rate_.data(), f_.data());
    rate_ *= h_;
    for (Eigen::Index i = 0; i < stages_; ++i) {
        difference_ = h_ * f_.col(0);
        give(difference_, slope_of_velocity(i));
        difference_ = Eigen::Map<const VecX>(system_.v(y_), n_) + coefficients_.c[i] * rate_;
        give(difference_, slope_of_position(i));
    }
    return status;
}

/// From the guess, and where that leads nowhere, or out of the chart, from an unchanged velocity: springs that are
/// stiff make f swing.
Status ImplicitStages::iterate() {
    const Status status = newton_.solve(*this, weights_, turned_.data());
    if (status != Status::newton_failed && status != Status::left_chart) return status;
    turned_.setZero();
    for (Eigen::Index i = 0; i < stages_; ++i) scale_.to_space(y_, system_.v(y_), slope_of_position(i));
    const Status again = newton_.solve(*this, weights_, turned_.data());
    return again == Status::newton_failed ? status : again;
}

void ImplicitStages::take(const Real* turned) {
    for (Eigen::Index i = 0; i < stages_; ++i) {
        scale_.from_space(y_, turned + i * n_, k_.col(i).data());
        scale_.from_space(y_, turned + (stages_ + i) * n_, w_.col(i).data());
    }
}

Real ImplicitStages::size() const {
    Real most = motion_;
    for (Eigen::Index i = 0; i < stages_; ++i) most = max(most, Real(abs(h_) * scale_.of_velocity(f_.col(i).data())));
    return most;
}

std::unique_ptr<ImplicitStages> implicit_stages(System& system, StageCoefficients coefficients, StageCentre centre) {
    if (action_on(system)) return std::make_unique<ActedStages>(system, std::move(coefficients), centre);
    return std::make_unique<TangentStages>(system, std::move(coefficients), centre);
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
