// SPDX-License-Identifier: BSD-3-Clause
#include "methods/symmetric_projection/symmetric_projection.hpp"

#include <algorithm>
#include <utility>

#include "methods/contract/integrator.hpp"
#include "methods/implicit/newton/newton.hpp"
#include "methods/implicit/position_weights.hpp"
#include "methods/implicit/predictor.hpp"
#include "methods/symmetric_projection/projected_step.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

class SymmetricProjection final : public Integrator, private Equations {
  public:
    SymmetricProjection(System& system, const MakeProjectedStep& make)
        : system_(system),
          n_(system.velocities()),
          m_(system.constraints()),
          scale_(system),
          rows_(system, scale_),
          equations_(make(system, scale_)),
          slopes_(equations_->slopes()),
          newton_(equations_->unknowns()),
          past_(equations_->unknowns()),
          change_(VecX::Zero(n_)),
          x_(VecX::Zero(equations_->unknowns())),
          r_(x_),
          turned_(x_),
          weights_(VecX::Ones(x_.size())) {}

    Status start(const Real&, const Real*) override {
        h_ = 0;
        return Status::ok;
    }

    Status step(const Real& t, const Real& h, Real* y) override {
        if (h == 0) return system_.evaluate(t, y, system_.v(y), change_.data());
        q_ = y;
        equations_->begin(t, h, y, system_.v(y));
        if (h != h_)
            if (const Status status = begin(t, h, y); status != Status::ok) return status;
        h_ = 0;  // until this step has succeeded
        weigh(t, h, y);
        Status status = iterate();
        work_.newton_iterations = newton_.iterations();
        if (status == Status::newton_failed) status = find_cause();
        if (status == Status::ok) status = settle();
        if (status != Status::ok) return status;
        finish(y);
        h_ = h;
        return Status::ok;
    }

  private:
    /// Forgets earlier steps, and guesses from the index-1 form.
    Status begin(const Real& t, const Real& h, const Real* y) {
        newton_.forget(), scale_.forget(), past_.clear();
        scale_.weigh(y);
        if (const Status status = system_.evaluate(t, y, system_.v(y), change_.data()); status != Status::ok)
            return status;
        change_ *= h;
        x_.setZero();
        equations_->guess(change_, x_.data());
        remember();
        return rows_.start(t, y);
    }

    /// What the iteration has learnt holds for its weights.
    void weigh(const Real& t, const Real& h, const Real* y) {
        scale_.weigh(y);
        motion_ = scale_.of_motion(t, h, y);
        if (rows_.refresh(t, y)) newton_.forget();
        if (rows_.rebalance(motion_, h)) newton_.forget();
        places_ = rows_.of_places(h);
        if (m_ == 0) return;
        weights_.segment(slopes_ * n_, m_) = rows_.weights();
        weights_.tail(m_) = rows_.weights_of_velocities();
    }

    void guess() { past_.guess(newton_.stiff() ? 0 : past_.best_degree(slopes_ * n_), turned_); }

    /// From the guess; where that leads nowhere, out of the chart, or to poses in which rows lose rank, from the last
    /// slopes without what is known of mu and nu, which leap beside such poses, and from an unchanged velocity: springs
    /// that are stiff make its change swing.
    Status iterate() {
        guess();
        Status status = newton_.solve(*this, weights_, turned_.data());
        if (!leads_nowhere(status)) return status;
        newton_.forget();
        past_.guess(0, turned_);
        turned_.tail(2 * m_).setZero();
        status = newton_.solve(*this, weights_, turned_.data());
        if (!leads_nowhere(status)) return status;
        change_.setZero(), x_.setZero();
        equations_->guess(change_, x_.data());
        turn();
        return newton_.solve(*this, weights_, turned_.data());
    }
    static bool leads_nowhere(Status status) {
        return status == Status::newton_failed || status == Status::singular_kkt || status == Status::left_chart;
    }

    /// An iteration fails near poses in which rows lose rank. If the guess is such a pose, the system names the joints.
    Status find_cause() {
        guess();
        take(turned_.data());
        equations_->place(x_.data());
        return equations_->prepare() == Status::singular_kkt ? Status::singular_kkt : Status::newton_failed;
    }

    void take(const Real* turned) {
        for (Eigen::Index i = 0; i < slopes_; ++i) scale_.from_space(q_, turned + i * n_, x_.data() + i * n_);
        std::copy_n(turned + slopes_ * n_, 2 * m_, x_.data() + slopes_ * n_);
    }
    void turn() { give(x_, turned_.data()); }
    void give(const VecX& x, Real* turned) const {
        for (Eigen::Index i = 0; i < slopes_; ++i) scale_.to_space(q_, x.data() + i * n_, turned + i * n_);
        std::copy_n(x.data() + slopes_ * n_, 2 * m_, turned + slopes_ * n_);
    }

    Status residual(const Real* turned, Real* r) override {
        take(turned);
        const Status status = equations_->residual(x_.data(), r_.data());
        give(r_, r);
        return status;
    }
    Real size() const override { return max(max(motion_, places_), equations_->largest_change()); }
    Real round_off() const override { return rows_.remoteness() * system_.kkt_round_off(); }

    /// What is linear in the constraints holds for the last h f. Where something is stiff those have the round-off of
    /// large forces, and what they were to be is more accurate: mu and nu are then those for it.
    Status settle() {
        constexpr int most_corrections = 4;
        Real left = 0;
        for (Eigen::Index i = 0; i < slopes_; ++i) left = max(left, scale_.of_velocity(r_.data() + i * n_));
        const bool stiff = left > 64 * round_off() * size();
        if (!stiff) x_ -= r_;
        equations_->place(x_.data());
        for (int i = 0; stiff && m_ > 0 && i < most_corrections; ++i) {
            if (const Status status = equations_->correction(x_.data(), r_.data()); status != Status::ok) return status;
            x_ -= r_;
            equations_->place(x_.data());
        }
        return Status::ok;
    }

    void remember() {
        turn();
        past_.push(turned_);
    }

    void finish(Real* y) {
        const VecX& velocity = equations_->velocity(x_.data());
        remember();
        std::copy(equations_->configuration().begin(), equations_->configuration().end(), y);
        std::copy_n(velocity.data(), n_, system_.v(y));
    }

    System& system_;
    Eigen::Index n_, m_;
    MotionScale scale_;
    PositionWeights rows_;
    std::unique_ptr<ProjectedStep> equations_;
    Eigen::Index slopes_;
    Newton newton_;
    Predictor past_;  // of turned_
    VecX change_;
    VecX x_, r_, turned_, weights_;  // slopes, mu, nu; turned_ with slopes weighted and in space axes
    Real h_ = 0;                     // step that the memory belongs to; 0: none
    Real motion_ = 0, places_ = 0;
    const Real* q_ = nullptr;
};

std::string why_not_projected(const System& system) {
    return system.position_constraints() < system.constraints() ? "rows without a position level (rolling)" : "";
}

}  // namespace

Factory symmetric_projection(int stages, MakeProjectedStep make) {
    Factory factory;
    factory.make = [make = std::move(make)](System& system, const OptionValues&, const MethodDescription&) {
        return std::make_unique<SymmetricProjection>(system, make);
    };
    factory.stages = stages;
    factory.declines = why_not_projected;
    return factory;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
