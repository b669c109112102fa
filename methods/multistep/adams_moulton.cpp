// SPDX-License-Identifier: BSD-3-Clause
#include "methods/multistep/adams_moulton.hpp"

#include <algorithm>
#include <utility>

#include "methods/contract/integrator.hpp"
#include "methods/contract/state_space.hpp"
#include "methods/implicit/stages/implicit_stages.hpp"
#include "methods/tableaus/bound_tableau.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// The end of the step as its only stage.
StageCoefficients end_of_step(const Real& weight) {
    const MatX a = MatX::Constant(1, 1, weight);
    return {a, a, VecX::Constant(1, weight), VecX::Ones(1)};
}

std::unique_ptr<Integrator> starter_of(System& system) {
    const Method& precise = method("rkmk/verner6");
    return precise.factory.make(system, with_defaults({}, precise.description.options), precise.description);
}

class AdamsMoulton final : public Integrator {
  public:
    AdamsMoulton(System& system, const std::vector<Coefficient>& weights)
        : space_(system),
          n_(system.velocities()),
          size_(static_cast<std::size_t>(space_.group().size())),
          starter_(starter_of(system)),
          stages_(implicit_stages(system, end_of_step(value(weights[0])), StageCentre::start)),
          points_(weights.size() - 1, std::vector<Real>(size_)),
          slopes_(weights.size() - 1, VecX::Zero(2 * n_)),
          earlier_(size_),
          inverse_(size_),
          apart_(size_),
          sigma_(VecX::Zero(2 * n_)),
          offset_(sigma_) {
        for (std::size_t j = 1; j < weights.size(); ++j) weights_.push_back(value(weights[j]));
        stages_->position_offset = stages_->velocity_offset = VecX::Zero(n_);
    }

    Status start(const Real&, const Real*) override {
        known_ = false;
        return Status::ok;
    }

    Status step(const Real& t, const Real& h, Real* y) override {
        const bool fresh = !std::exchange(known_, false) || h != h_;  // known again if this step succeeds
        h_ = h;
        std::rotate(points_.rbegin(), points_.rbegin() + 1, points_.rend());
        std::rotate(slopes_.rbegin(), slopes_.rbegin() + 1, slopes_.rend());
        if (const Status status = record(0, t, y); status != Status::ok) return status;
        if (fresh)
            if (const Status status = begin(t, h, y); status != Status::ok) return status;
        if (!set_offsets(h)) return Status::left_chart;
        const Status status = stages_->advance(t, h, y);
        work_.newton_iterations = stages_->iterations();
        known_ = status == Status::ok;
        return status;
    }

  private:
    /// The state j steps ago, and its slope.
    Status record(std::size_t j, const Real& t, const Real* y) {
        std::copy_n(y, size_, points_[j].begin());
        return space_.slope(t, y, slopes_[j].data());
    }

    /// The k - 1 steps that would have led to y.
    Status begin(const Real& t, const Real& h, const Real* y) {
        stages_->forget();
        std::copy_n(y, earlier_.size(), earlier_.begin());
        if (const Status status = starter_->start(t, y); status != Status::ok) return status;
        for (std::size_t j = 1; j < points_.size(); ++j) {
            const int back = static_cast<int>(j);
            Status status = starter_->step(t - (back - 1) * h, -h, earlier_.data());
            if (status == Status::ok) status = record(j, t - back * h, earlier_.data());
            // A motion that runs away within such steps has none forwards either.
            const bool runs_away = status == Status::non_finite || status == Status::left_chart;
            if (status != Status::ok) return runs_away ? Status::newton_failed : status;
        }
        return Status::ok;
    }

    /// h sum_j beta_j k~_j of the known slopes; false outside the chart.
    bool set_offsets(const Real& h) {
        const Group& group = space_.group();
        offset_ = h * weights_[0] * slopes_[0];
        group.inverse(points_[0].data(), inverse_.data());
        for (std::size_t j = 1; j < weights_.size(); ++j) {
            group.multiply(inverse_.data(), points_[j].data(), apart_.data());
            group.log(apart_.data(), sigma_.data());
            if (!group.dexpinv_left(sigma_.data(), slopes_[j].data(), sigma_.data())) return false;
            offset_ += h * weights_[j] * sigma_;
        }
        stages_->position_offset = offset_.head(n_), stages_->velocity_offset = offset_.tail(n_);
        return true;
    }

    StateSpace space_;
    Eigen::Index n_;
    std::size_t size_;
    std::unique_ptr<Integrator> starter_;
    std::unique_ptr<ImplicitStages> stages_;
    std::vector<Real> weights_;              // from beta_0 on
    std::vector<std::vector<Real>> points_;  // the states j steps ago, from 0
    std::vector<VecX> slopes_;               // there
    std::vector<Real> earlier_, inverse_, apart_;
    VecX sigma_, offset_;
    Real h_ = 0;          // step that they are apart
    bool known_ = false;  // whether they are those before the next step
};

}  // namespace

Factory adams_moulton(const std::vector<Coefficient>& weights) {
    Factory factory;
    factory.make = [weights](System& system, const OptionValues&, const MethodDescription&) {
        return std::make_unique<AdamsMoulton>(system, weights);
    };
    factory.stages = 1;
    factory.takes_actions = true;
    return factory;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
