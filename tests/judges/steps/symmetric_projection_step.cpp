// SPDX-License-Identifier: BSD-3-Clause
//
// The implicit midpoint rule and the Gauss method with 2 stages between two equal projections. Only the ends of a step
// are known: mu and nu are those that leave least of the equations, and what they leave must vanish.
#include "tests/judges/steps/symmetric_projection_step.hpp"

#include <Eigen/QR>
#include <optional>

#include "tests/judges/steps/collocation_step.hpp"
#include "tests/judges/steps/stabilised_step.hpp"
#include "tests/judges/steps/step_checks.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// The equations of one step for given mu and nu.
class DenseProjectedStep {
  public:
    DenseProjectedStep(RecordedRun& run, const RecordedState& before, const RecordedState& after,
                       const SymmetricProjectionForm& form)
        : run_(run), before_(before), after_(after) {
        if (form.gauss_stages > 1) gauss_.emplace(run, gauss_form(form.gauss_stages));
        const auto directions = [&](const RecordedState& state) {
            MatX G = run.position_rows(state).transpose();
            if (!form.without_mass) run.solve_mass(state.q, G);
            return G;
        };
        first_ = directions(before), last_ = form.start_alone ? first_ : directions(after);
        if (form.after_alone) first_.setZero();
        mu = VecX::Zero(first_.cols()), nu = mu;
        if (mu.size() > 0) decomposition_.compute(first_ + last_);
    }

    VecX mu, nu;
    VecX of_positions, of_velocities;  ///< residuals

    void evaluate() {
        const Real& h = run_.h;
        const VecX q = run_.bodies.moved(before_.q, h * first_ * mu),
                   q_end = run_.bodies.moved(after_.q, -h * last_ * mu);
        const VecX v = before_.v + first_ * nu, v_end = after_.v - last_ * nu;
        of_positions = run_.bodies.increment(q, q_end) / h;
        of_velocities = v_end - v;
        if (!is_finite()) return;
        gauss_ ? take_gauss_step({.t = before_.t, .q = q, .v = v, .lambda = {}})
               : take_midpoint_step(q, (v + v_end) / 2);
    }
    /// Modified equations may have no solution.
    bool is_finite() const { return of_positions.allFinite() && of_velocities.allFinite(); }
    /// Far below the tolerance.
    bool is_met() const {
        const Real most = max(of_positions.cwiseAbs().maxCoeff(), of_velocities.cwiseAbs().maxCoeff());
        return most < equations_tolerance() / 16;
    }
    /// The multipliers that take away what they can, to first order in h.
    void improve() {
        if (mu.size() == 0) return;
        mu += decomposition_.solve(of_positions);
        nu += decomposition_.solve(of_velocities);
    }

  private:
    void take_midpoint_step(const VecX& q, const VecX& V) {
        const Real& h = run_.h;
        of_positions -= V;
        of_velocities -=
            h * run_.index1_rate({.t = before_.t + h / 2, .q = run_.bodies.moved(q, h / 2 * V), .v = V, .lambda = {}});
    }
    void take_gauss_step(const RecordedState& start) {
        gauss_->sweep(start, 2);
        const VecX u = gauss_->increment();
        of_positions -= u.head(of_positions.size()) / run_.h;
        of_velocities -= u.tail(of_velocities.size());
    }

    RecordedRun& run_;
    const RecordedState &before_, &after_;
    std::optional<DenseCollocation> gauss_;  // iterated along with the multipliers
    MatX first_, last_;                      // G(q), G(q+)
    Eigen::ColPivHouseholderQR<MatX> decomposition_;
};

Violations symmetric_violations(RecordedRun& run, const SymmetricProjectionForm& form) {
    constexpr int iterations = KREISEL_QUAD ? 60 : 30;
    Violations found;
    for (std::size_t i = 0; i + 1 < run.states.size(); ++i) {
        DenseProjectedStep step(run, run.states[i], run.states[i + 1], form);
        step.evaluate();
        for (int k = 0; k < iterations && step.is_finite() && !step.is_met(); ++k) step.improve(), step.evaluate();
        found.see("q~+ of a step from q~, v~", step.of_positions);
        found.see("v~+ of a step from q~, v~", step.of_velocities);
        see_positions(run, run.states[i + 1], found);
        see_velocities(run, run.states[i + 1], found);
    }
    return found;
}

}  // namespace

Objection symmetric_projection_step_objection(const Method& method, const SymmetricProjectionForm& form) {
    const int steps = form.gauss_stages > 1 ? 1 : 3;  // dense stages take long
    return on_models_with_and_without_joints(method, {}, steps,
                                             [&](RecordedRun& run) { return symmetric_violations(run, form); });
}

KREISEL_STEP_CHECK("symmetric_projection/midpoint",
                   [](const Method& method) { return symmetric_projection_step_objection(method); });
KREISEL_STEP_CHECK("symmetric_projection/gauss2", [](const Method& method) {
    return symmetric_projection_step_objection(method, {.gauss_stages = 2});
});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
