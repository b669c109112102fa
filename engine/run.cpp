// SPDX-License-Identifier: BSD-3-Clause
#include "engine/run.hpp"

#include "engine/observers/conservation.hpp"
#include "engine/observers/errors.hpp"
#include "engine/observers/samples.hpp"
#include "engine/observers/timing.hpp"
#include "methods/simulation.hpp"
#include "problems/problem.hpp"
#include "support/number_text.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// Sum of all entries: finite if and only if all entries are, except for overflow, which ends a run too.
bool all_finite(const std::vector<Real>& y) {
    Real sum = 0;
#pragma GCC unroll 3
    for (const Real& x : y) sum += x;
    return isfinite(sum);
}

/// Names the first quantity that is not finite.
std::string where_not_finite(const std::vector<BodyState>& states, const Model& model) {
    for (std::size_t i = 0; i < states.size(); ++i) {
        const BodyState& s = states[i];
        const std::pair<const char*, Real> sums[] = {
            {"x", s.x.sum()}, {"R", s.R.sum()}, {"v", s.v.sum()}, {"omega", s.omega.sum()}};
        for (const auto& [quantity, sum] : sums)
            if (!isfinite(sum))
                return std::string("finiteness of ") + quantity + " of body \"" + model.bodies[i].name + "\"";
    }
    return "finiteness of the state";
}

/// A simulation and its observers: all objects of one cell.
class Run {
  public:
    Run(const Cell& cell, SampleSink* sink);
    Outcome execute(const Reference* reference, const std::stop_token& stop);

  private:
    Real time(long step) const { return step == cell_.steps ? t_end_ : Real(h_ * Real(step)); }
    bool observes() const { return !step_metrics_.idle() || !integral_metrics_.idle() || samples_; }
    void observe(long step);
    void time_steps(const std::stop_token& stop);
    void advance(const std::stop_token& stop);
    [[gnu::cold]] void fail(Status status, long step, const std::string& where, const std::string& reason = "");
    [[gnu::cold]] void fail_not_finite(long step);
    void finish(const Reference* reference);
    void report_end(const Real& t, const Reference* reference);

    const Cell& cell_;
    double heap_before_;
    Simulation simulation_;
    double memory_;
    Observation observation_;
    StepMetrics step_metrics_;
    IntegralMetrics integral_metrics_;
    std::optional<JointForces> joint_forces_;
    std::optional<Conservation> conservation_;
    std::optional<Samples> samples_;
    Real t_end_, h_;
    long evaluations_ = 0;  // of the steps of one run
    Outcome outcome_;
};

Run::Run(const Cell& cell, SampleSink* sink)
    : cell_(cell),
      heap_before_(heap_bytes()),
      simulation_(problem(cell.problem).build(Parameters(cell.parameters)),
                  {cell.formulation, cell.method, cell.options, cell.projection, cell.projection_options}),
      memory_(heap_bytes() - heap_before_),
      observation_(simulation_.system()),
      step_metrics_(simulation_.system(), cell.metrics),
      integral_metrics_(simulation_.system(), cell.metrics),
      t_end_(decimal(cell.t_end)),
      h_(t_end_ / Real(cell.steps)) {
    outcome_.constraints = to_summary(simulation_.system().constraint_rank());
    outcome_.bodies = simulation_.system().bodies();
    observation_.move_to(simulation_.time(), simulation_.state().data());
    if (!cell.timed || cell.samples > 0) joint_forces_.emplace(simulation_.system(), simulation_.model());
    if (!cell.timed) conservation_.emplace(observation_);
    if (cell.samples > 0)
        samples_.emplace(Sampled{simulation_.model(), *joint_forces_, step_metrics_, integral_metrics_},
                         cell.steps / cell.samples, sink);
}

Outcome Run::execute(const Reference* reference, const std::stop_token& stop) {
    const double begin = thread_seconds();
    observe(0);
    if (cell_.timed)
        time_steps(stop);
    else
        advance(stop);
    finish(reference);
    outcome_.cost.cpu_s = thread_seconds() - begin;
    return std::move(outcome_);
}

void Run::observe(long step) {
    observation_.move_to(simulation_.time(), simulation_.state().data());
    step_metrics_.observe(observation_);
    integral_metrics_.observe(observation_);
    if (samples_) samples_->observe(step, observation_, simulation_.multipliers());
}

/// Runs several times from the start; the evaluations counted are those of one run.
void Run::time_steps(const std::stop_token& stop) {
    if (memory_ > 0) outcome_.cost.memory = memory_;
    const std::vector<Real> start = simulation_.state();
    RepeatedTimes times;
    while (outcome_.status == "ok" && !times.reliable()) {
        simulation_.restart(0, start);
        const double begin = thread_seconds();
        advance(stop);
        times.add(thread_seconds() - begin);
        if (evaluations_ == 0) evaluations_ = simulation_.system().evaluations();
    }
    if (outcome_.status == "ok") outcome_.cost.step_s = times.fastest() / static_cast<double>(cell_.steps);
}

void Run::advance(const std::stop_token& stop) {
    if (const Status status = simulation_.restart(); status != Status::ok)
        return fail(status, 0, "start", simulation_.system().reason(status));
    const std::vector<Real>& y = simulation_.state();
    const long steps = cell_.steps;
    const bool observing = observes();
    for (long i = 0; i < steps; ++i) {
        if (i % 256 == 0 && stop.stop_requested()) {
            outcome_.status = "interrupted";
            return;
        }
        if (const Status status = simulation_.step(h_, time(i + 1)); status != Status::ok)
            return fail(status, i, simulation_.failed_part(), simulation_.failure_reason());
        if (!all_finite(y)) return fail_not_finite(i);
        outcome_.steps_done = i + 1;
        if (observing) observe(i + 1);
    }
}

void Run::fail(Status status, long step, const std::string& where, const std::string& reason) {
    outcome_.status = name(status);
    outcome_.detail = where + " failed in step " + std::to_string(step + 1) + " of " + std::to_string(cell_.steps) +
                      ", from t = " + brief_text(to_double(time(step))) + " s";
    if (!reason.empty()) outcome_.detail += ": " + reason;
}

void Run::fail_not_finite(long step) {
    fail(Status::non_finite, step, where_not_finite(simulation_.bodies(), simulation_.model()));
}

void Run::finish(const Reference* reference) {
    const Real t = time(outcome_.steps_done);
    const bool finished = outcome_.status == "ok";
    outcome_.t_reached = to_double(t);
    outcome_.cost.evaluations = cell_.timed ? evaluations_ : simulation_.system().evaluations();
    outcome_.cost.projection_iterations = simulation_.projection().iterations();
    if (finished && !cell_.timed) report_end(t, reference);
    outcome_.cost.output_evaluations = observation_.evaluations();
    if (joint_forces_) outcome_.cost.output_evaluations += joint_forces_->evaluations();
    // A run that failed in its first step has measured only its start.
    if (!finished && outcome_.steps_done == 0) return;
    step_metrics_.report(finished, outcome_.metrics);
    integral_metrics_.report(finished, outcome_.metrics);
}

void Run::report_end(const Real& t, const Reference* reference) {
    observation_.move_to(t, simulation_.state().data());
    const bool found = joint_forces_->find(t, observation_.y(), simulation_.multipliers());
    std::vector<Real> multipliers;
    if (found && outcome_.constraints.has_redundant_rows()) {  // they are not unique
        for (const Real& x : joint_forces_->multipliers()) outcome_.constraints.least_norm.push_back(to_number(x));
    } else if (found) {
        multipliers = joint_forces_->multipliers();
    }
    const std::vector<BodyState>& states = observation_.bodies();
    outcome_.final = to_report(t, states, simulation_.model(), multipliers, observation_.springs());
    if (found) joint_forces_->report(*outcome_.final);
    if (reference)
        report_errors(*reference, cell_.t_end, states, multipliers, simulation_.system().constraint_rows(),
                      cell_.metrics, outcome_.metrics);
    outcome_.lost = conservation_->lost(observation_);
}

}  // namespace

Outcome run_cell(const Cell& cell, const Reference* reference, const std::stop_token& stop, SampleSink* samples) {
    return Run(cell, samples).execute(reference, stop);
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
