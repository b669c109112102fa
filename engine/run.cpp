// SPDX-License-Identifier: BSD-3-Clause
#include "engine/run.hpp"

#include <algorithm>

#include "engine/begin.hpp"
#include "engine/observers/conservation.hpp"
#include "engine/observers/errors.hpp"
#include "engine/observers/timing.hpp"
#include "engine/pace.hpp"
#include "engine/sampler.hpp"
#include "engine/structure_probe.hpp"
#include "methods/contract/method.hpp"
#include "problems/problem.hpp"
#include "support/number_text.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// Some milliseconds of a body's steps, after which a run looks at its watch.
constexpr long steps_of_a_body = KREISEL_QUAD ? 16 : 256;
/// What the run that is measured takes of a cell whose run is then repeated.
constexpr double measured_share = 0.5;

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

Setup setup_of(const Cell& cell) {
    return {cell.formulation,        cell.method,    cell.options, cell.projection, cell.projection_options,
            decimal(cell.tolerance), cell.controller};
}

/// How samples are taken: between steps, if they are of order p - 1 at least, else steps are cut short for them.
Sampler::Between between_steps(const Cell& cell) {
    if (cell.tolerance == 0 || !cell.dense) return Sampler::Between::none;
    const MethodDescription& method = kreisel::method(cell.method).description;
    const int least = kreisel::method(cell.method).factory.order(cell.options, method.order).configuration - 1;
    if (method.dense > 0 && method.dense >= least) return Sampler::Between::own;
    return Interpolant::order >= least ? Sampler::Between::ends : Sampler::Between::none;
}

/// Takes a simulation to where its cell begins.
const std::vector<Real>& placed(Simulation& simulation, const Cell& cell) {
    if (!cell.begin) return simulation.state();
    const Model moved = moved_to(simulation.model(), *cell.begin);
    simulation.move_to(from_text(cell.begin->t.text), initial_state(simulation.system(), moved));
    return simulation.state();
}

/// A simulation and its observers: all objects of one cell.
class Run {
  public:
    /// `reference` and `sink` may be null.
    Run(const Cell& cell, const Reference* reference, SampleSink* sink);
    Outcome execute(const Watch& watch);
    /// A round of runs without measuring: their mean time, s; nothing if one has not come to its end.
    std::optional<double> time(const Watch& watch);

  private:
    bool observes() const { return !step_metrics_.idle() || !integral_metrics_.idle() || sampler_; }
    void observe();
    void advance(bool observing, const Watch& watch);
    void observe_step();
    void measure(const Watch& watch);
    double share_of_probe() const;
    void time_steps(const Watch& watch);
    RepeatedTimes repeat(Watch watch);
    Cost work() const;
    std::string place(long step) const;
    [[gnu::cold]] void fail(Status status, const std::string& where, const std::string& reason = "");
    [[gnu::cold]] void fail_not_finite();
    void finish();
    void report_end(const Real& t);

    const Cell& cell_;
    const Reference* reference_;
    double heap_before_;
    Simulation simulation_;
    double memory_;
    const std::vector<Real> start_;
    const Real begin_;
    Pace pace_;
    const long steps_between_looks_;
    Observation observation_;
    StepMetrics step_metrics_;
    IntegralMetrics integral_metrics_;
    std::optional<JointForces> joint_forces_;
    std::optional<StructureProbe> structure_;
    std::optional<Conservation> conservation_;
    std::optional<SampleErrors> sample_errors_;
    std::optional<Sampler> sampler_;
    Outcome outcome_;
};

Run::Run(const Cell& cell, const Reference* reference, SampleSink* sink)
    : cell_(cell),
      reference_(reference),
      heap_before_(cell.timed ? heap_bytes() : 0),
      simulation_(problem(cell.problem).build(Parameters(cell.parameters)), setup_of(cell)),
      memory_(cell.timed ? heap_bytes() - heap_before_ : 0),
      start_(placed(simulation_, cell)),
      begin_(simulation_.time()),
      pace_(cell, simulation_),
      steps_between_looks_(std::max(1L, steps_of_a_body / simulation_.system().bodies())),
      observation_(simulation_.system()),
      step_metrics_(simulation_.system(), cell.metrics),
      integral_metrics_(simulation_.system(), cell.metrics) {
    outcome_.constraints = to_summary(simulation_.system().constraint_rank());
    outcome_.bodies = simulation_.system().bodies();
    observation_.move_to(simulation_.time(), simulation_.state().data());
    if (!cell.timed || cell.samples > 0) joint_forces_.emplace(simulation_.system(), simulation_.model());
    if (!cell.timed) conservation_.emplace(observation_);
    if (!cell.timed && StructureProbe::is_wanted(cell)) structure_.emplace(cell, setup_of(cell));
    if (reference && cell.samples > 0)
        sample_errors_.emplace(*reference, simulation_.system().constraint_rows(), cell.metrics);
    if (cell.samples > 0)
        sampler_.emplace(cell, simulation_,
                         Sampled{simulation_.model(), *joint_forces_, step_metrics_, integral_metrics_,
                                 sample_errors_ ? &*sample_errors_ : nullptr,
                                 cell.repeated ? [this] { return work(); } : std::function<Cost()>()},
                         between_steps(cell), sink);
}

Outcome Run::execute(const Watch& watch) {
    const double begin = thread_seconds();
    cell_.timed ? time_steps(watch) : measure(cell_.repeated ? watch.part(0, measured_share) : watch);
    finish();
    outcome_.cost.cpu_s = thread_seconds() - begin;
    if (cell_.repeated && outcome_.status == "ok") outcome_.cost.run_s = repeat(watch.part(measured_share, 1)).mean();
    return std::move(outcome_);
}

void Run::measure(const Watch& watch) {
    observe();
    if (structure_) structure_->observe(simulation_.time(), start_);
    if (sampler_) sampler_->begin(observation_);
    const double probed = share_of_probe();
    advance(observes(), watch.part(probed, 1 - probed));
    outcome_.cost = work();
}

/// What the step at the start takes of a cell whose steps are measured at both ends, by solves.
double Run::share_of_probe() const {
    if (!structure_ || pace_.to_tolerance()) return 0;
    const double stages = std::max(1, kreisel::method(cell_.method).description.stages);
    const auto probing = static_cast<double>(structure_->evaluations());
    return probing / (2 * probing + stages * static_cast<double>(cell_.steps));
}

void Run::observe() {
    observation_.move_to(simulation_.time(), simulation_.state().data());
    step_metrics_.observe(observation_);
    integral_metrics_.observe(observation_);
}

/// The work counted is that of the first run.
void Run::time_steps(const Watch& watch) {
    if (memory_ > 0) outcome_.cost.memory = memory_;
    const RepeatedTimes times = repeat(watch);
    if (outcome_.status != "ok") return;
    outcome_.cost.run_s = times.mean();
    outcome_.cost.step_s = times.mean() / static_cast<double>(outcome_.steps_done);
}

/// Runs several times from the start, without observers. What takes more than one run is soon done, so that the first
/// counts for all.
RepeatedTimes Run::repeat(Watch watch) {
    RepeatedTimes times;
    while (outcome_.status == "ok" && !times.enough()) {
        simulation_.restart(begin_, start_);
        const double begin = thread_seconds();
        advance(false, watch);
        times.add(thread_seconds() - begin);
        watch = watch.part(1, 1);
        if (cell_.timed && outcome_.cost.evaluations == 0) outcome_.cost = work();
    }
    return times;
}

void Run::advance(bool observing, const Watch& watch) {
    outcome_.steps_done = 0;
    if (const Status status = pace_.begin(); status != Status::ok)
        return fail(status, simulation_.failed_part(), simulation_.failure_reason());
    const std::vector<Real>& y = simulation_.state();
    const bool sampling = observing && sampler_;
    long next_look = 0;
    while (!pace_.arrived()) {
        if (outcome_.steps_done >= next_look) {
            if (watch.stop_requested()) {
                outcome_.status = "interrupted";
                return;
            }
            watch.tell(pace_.share());
            next_look += steps_between_looks_;
        }
        if (sampling) sampler_->remember();
        const Status status = pace_.step(sampling ? sampler_->limit() : pace_.t_end());
        if (status != Status::ok) return fail(status, simulation_.failed_part(), simulation_.failure_reason());
        if (!all_finite(y)) return fail_not_finite();
        outcome_.steps_done = pace_.steps_done();
        if (observing) observe_step();
    }
    watch.tell(1);
}

void Run::observe_step() {
    if (sampler_) sampler_->between(observation_);
    observe();
    if (sampler_) sampler_->at_end(pace_.steps_done(), observation_);
}

std::string Run::place(long step) const {
    const std::string from = ", from t = " + brief_text(to_double(pace_.time(step))) + " s";
    return "step " + std::to_string(step + 1) + (pace_.to_tolerance() ? "" : " of " + std::to_string(cell_.steps)) +
           from;
}

void Run::fail(Status status, const std::string& where, const std::string& reason) {
    outcome_.status = name(status);
    outcome_.detail = where + " failed in " + place(outcome_.steps_done);
    if (!reason.empty()) outcome_.detail += ": " + reason;
}

void Run::fail_not_finite() { fail(Status::non_finite, where_not_finite(simulation_.bodies(), simulation_.model())); }

Cost Run::work() const {
    Cost cost = outcome_.cost;
    cost.evaluations = simulation_.system().evaluations();
    cost.exponentials = simulation_.work().exponentials;
    cost.brackets = simulation_.work().brackets;
    cost.newton_iterations = simulation_.work().newton_iterations;
    cost.projection_iterations = simulation_.projection().iterations();
    cost.accepted = outcome_.steps_done;
    cost.rejected = simulation_.stepper() ? simulation_.stepper()->rejected() : 0;
    return cost;
}

std::optional<double> Run::time(const Watch& watch) {
    const double seconds = repeat(watch).mean();
    return outcome_.status == "ok" ? std::optional(seconds) : std::nullopt;
}

void Run::finish() {
    const Real t = pace_.time(outcome_.steps_done);
    outcome_.t_reached = to_double(t);
    if (outcome_.status == "ok" && !cell_.timed) report_end(t);
    const bool finished = outcome_.status == "ok";
    outcome_.cost.output_evaluations = observation_.evaluations();
    if (joint_forces_) outcome_.cost.output_evaluations += joint_forces_->evaluations();
    if (sampler_) outcome_.cost.output_evaluations += sampler_->evaluations();
    if (structure_) outcome_.cost.output_evaluations += structure_->evaluations();
    // A run that failed in its first step has measured only its start.
    if (!finished && outcome_.steps_done == 0) return;
    step_metrics_.report(finished, outcome_.metrics);
    integral_metrics_.report(finished, outcome_.metrics);
    if (structure_) structure_->report(outcome_);
}

void Run::report_end(const Real& t) {
    observation_.move_to(t, simulation_.state().data());
    const bool found = joint_forces_->find(t, observation_.y(), simulation_.multipliers());
    if (found && !all_finite(joint_forces_->multipliers())) {  // of masses like 1e90, though they move as they should
        outcome_.status = name(Status::non_finite);
        outcome_.detail = "finiteness of the multipliers failed at the end";
        return;
    }
    std::vector<Real> multipliers;
    if (found && outcome_.constraints.has_redundant_rows()) {  // they are not unique
        for (const Real& x : joint_forces_->multipliers()) outcome_.constraints.least_norm.push_back(to_number(x));
    } else if (found) {
        multipliers = joint_forces_->multipliers();
    }
    if (structure_) structure_->observe(t, simulation_.state());
    const std::vector<BodyState>& states = observation_.bodies();
    outcome_.final = to_report(t, states, simulation_.model(), multipliers, observation_.springs());
    if (found) joint_forces_->report(*outcome_.final);
    if (reference_)
        report_errors(*reference_, cell_.t_end, {states, multipliers}, simulation_.system().constraint_rows(),
                      cell_.metrics, outcome_.metrics);
    if (sample_errors_) sample_errors_->report(cell_.t_end, outcome_.metrics);
    outcome_.lost = conservation_->lost(observation_);
}

}  // namespace

Outcome run_cell(const Cell& cell, const Reference* reference, const Watch& watch, SampleSink* samples) {
    Outcome outcome = Run(cell, reference, samples).execute(watch);
    if (outcome.status == "ok") watch.tell(1);
    return outcome;
}

std::optional<double> time_cell(const Cell& cell, const Watch& watch) {
    return Run(cell, nullptr, nullptr).time(watch);
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
