// SPDX-License-Identifier: BSD-3-Clause
#include "methods/projection/baumgarte_system.hpp"

#include "mechanics/step_watcher.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

class FeedbackSystem : public ForwardingSystem {
  public:
    FeedbackSystem(System& system, const Feedback& feedback)
        : ForwardingSystem(system),
          feedback_(feedback),
          force_(system.velocities()),
          gyroscopic_(force_),
          demand_(system.constraints()),
          residual_(demand_) {}

    /// Counts as a solve of the system without feedback.
    Status accelerations(const Real& t, const Real* q, const Real* v, Real* dv, Real* lambda) override {
        inner().count_evaluation();
        if (demand_.size() == 0) return inner().accelerations(t, q, v, dv, lambda);
        inner().applied_force(t, q, v, force_.data());
        // Forces have no status of their own.
        if (torsion_springs() > 0 && !inner().reason(Status::turn_lost).empty()) return Status::turn_lost;
        inner().gyroscopic_force(q, v, gyroscopic_.data());
        force_ += gyroscopic_;
        set_demand(t, q, v);
        return inner().solve_kkt(t, q, force_.data(), demand_.data(), dv, lambda);
    }

  protected:
    /// As it acts now, 1/s.
    virtual Feedback rates() const { return feedback_; }
    const Feedback& feedback() const { return feedback_; }

  private:
    /// What C v' is to be.
    void set_demand(const Real& t, const Real* q, const Real* v) {
        const Feedback rate = rates();
        inner().acceleration_bias(t, q, v, demand_.data());
        inner().velocity_residual(t, q, v, residual_.data());
        demand_ -= 2 * rate.alpha * residual_;
        inner().position_residual(t, q, residual_.data());
        const Eigen::Index positions = inner().position_constraints();
        demand_.head(positions) -= rate.beta * rate.beta * residual_.head(positions);
    }

    Feedback feedback_;
    VecX force_, gyroscopic_, demand_, residual_;
};

class StepFeedbackSystem final : public FeedbackSystem, public StepWatcher {
  public:
    using FeedbackSystem::FeedbackSystem;

    Status begin_step(const Real& t, const Real& h, const Real* y) override {
        h_ = h;
        return FeedbackSystem::begin_step(t, h, y);
    }
    Status end_step(Status result, const Real& t, Real* y) override {
        h_ = 0;
        return FeedbackSystem::end_step(result, t, y);
    }

  protected:
    Feedback rates() const override {
        return h_ == 0 ? Feedback{0, 0} : Feedback{feedback().alpha / h_, feedback().beta / h_};
    }

  private:
    Real h_ = 0;
};

}  // namespace

std::unique_ptr<System> with_feedback(System& system, const Feedback& feedback, bool per_step) {
    if (per_step) return std::make_unique<StepFeedbackSystem>(system, feedback);
    return std::make_unique<FeedbackSystem>(system, feedback);
}

std::string why_no_feedback(const MethodDescription& method) {
    if (method.reports_multipliers)
        return method.name + " has multipliers of its own, for constraints that it meets without feedback";
    if (method.form != Form::explicit_steps)
        return method.name + " is implicit, and takes its Jacobian from equations without feedback";
    return "";
}

std::vector<OptionDescription> feedback_options(const std::string& unit, double alpha, double beta) {
    return {{.name = "alpha",
             .summary = "feedback of C v + b, times 2, " + unit,
             .standard = alpha,
             .real_min = 0,
             .real_max = 1e6},
            {.name = "beta",
             .summary = "feedback of Phi, by its square, " + unit,
             .standard = beta,
             .real_min = 0,
             .real_max = 1e6}};
}

Feedback feedback_of(const OptionValues& options) {
    return {decimal(std::get<double>(options.at("alpha"))), decimal(std::get<double>(options.at("beta")))};
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
