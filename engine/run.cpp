// SPDX-License-Identifier: BSD-3-Clause
#include "engine/run.hpp"

#include <malloc.h>

#include <algorithm>
#include <cstdio>
#include <ctime>

#include "engine/metrics/conservation.hpp"
#include "engine/metrics/metrics.hpp"
#include "engine/report/joint_forces.hpp"
#include "engine/report/report.hpp"
#include "mechanics/start.hpp"
#include "methods/simulation.hpp"
#include "problems/problem.hpp"
#include "support/pattern.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

double thread_seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) / 1000000000;
}

/// Bytes on the heap of the whole process [glibc]; other threads' allocations count too, so timed cells run one at a
/// time. The allocator keeps blocks of earlier cells and counts them as used, so differences of a few kB are noise.
/// Zero under sanitizers, where malloc is not the C library's.
double heap_bytes() {
    const struct mallinfo2 info = mallinfo2();
    return static_cast<double>(info.uordblks + info.hblkhd);
}

/// Timed runs are repeated until the fastest is reliable.
constexpr int least_repeats = 5;
constexpr double least_seconds = 0.25;

/// Ten digits, for messages, whatever the precision.
std::string brief(const Real& x) {
    char text[32];
    std::snprintf(text, sizeof text, "%.10g", to_double(x));
    return text;
}

bool applies(const std::vector<std::string>& formulations, const std::string& name) {
    return formulations.empty() || std::find(formulations.begin(), formulations.end(), name) != formulations.end();
}

std::string only_for(const std::string& who, const std::vector<std::string>& formulations) {
    std::string list;
    for (const std::string& name : formulations) list += (list.empty() ? "" : ", ") + name;
    return who + " runs for " + list + " only";
}

/// Sum of all entries: finite if and only if all entries are, except for overflow, which ends a run too.
bool all_finite(const std::vector<Real>& y) {
    Real sum = 0;
#pragma GCC unroll 3
    for (const Real& x : y) sum += x;
    return isfinite(sum);
}

/// A run in progress: all objects of one cell.
class Run {
  public:
    explicit Run(const Cell& cell)
        : cell_(cell),
          heap_before_(heap_bytes()),
          simulation_(problem(cell.problem).build(Parameters(cell.parameters)),
                      {cell.formulation, cell.method, cell.options, cell.projection, cell.projection_options}),
          model_(simulation_.model()),
          system_(simulation_.system()),
          y_(simulation_.state()),
          monitor_(system_, cell.metrics),
          t_end_(decimal(cell.t_end)),
          h_(t_end_ / Real(cell.steps)),
          states_(model_.bodies.size()),
          springs_(model_.torsion_springs.size()) {
        for (const Body& body : model_.bodies) names_.push_back(body.name);
        outcome_.constraints = to_summary(system_.constraint_rank());
        outcome_.bodies = system_.bodies();
        if (!cell.timed || cell.samples > 0) joint_forces_.emplace(system_, model_);
        if (!cell.timed) conservation_.emplace(system_, y_.data());
    }

    Outcome execute(const Reference* reference, const std::stop_token& stop, SampleSink* samples) {
        const double begin = thread_seconds();
        samples_ = samples;
        if (cell_.samples > 0 && samples_) samples_->begin(columns());
        monitor_.observe(0, y_.data());
        if (cell_.samples > 0) sample(0);
        if (cell_.timed)
            time_steps(stop);
        else
            advance(stop);
        finish(reference);
        outcome_.cost.cpu_s = thread_seconds() - begin;
        return std::move(outcome_);
    }

  private:
    Real time(long step) const { return step == cell_.steps ? t_end_ : Real(h_ * Real(step)); }

    /// Runs several times from the start; the evaluations counted are those of one run.
    void time_steps(const std::stop_token& stop) {
        if (const double bytes = heap_bytes() - heap_before_; bytes > 0) outcome_.cost.memory = bytes;
        const std::vector<Real> start = y_;
        double total = 0, fastest = 0;
        for (int run = 0; outcome_.status == "ok" && (run < least_repeats || total < least_seconds); ++run) {
            simulation_.restart(0, start);
            const double begin = thread_seconds();
            advance(stop);
            const double seconds = thread_seconds() - begin;
            fastest = run == 0 ? seconds : std::min(fastest, seconds);
            total += seconds;
            if (run == 0) evaluations_ = system_.evaluations();
        }
        if (outcome_.status == "ok") outcome_.cost.step_s = fastest / static_cast<double>(cell_.steps);
    }

    void advance(const std::stop_token& stop) {
        if (const Status status = simulation_.restart(); status != Status::ok)
            return fail(status, 0, "start", system_.reason(status));
        const long steps = cell_.steps;
        const bool observing = !monitor_.idle(), sampling = cell_.samples > 0;
        for (long i = 0; i < steps; ++i) {
            if (i % 256 == 0 && stop.stop_requested()) {
                outcome_.status = "interrupted";
                return;
            }
            if (const Status status = simulation_.step(h_, time(i + 1)); status != Status::ok)
                return fail(status, i, simulation_.failed_part(), simulation_.failure_reason());
            if (!all_finite(y_)) return fail(Status::non_finite, i, where_not_finite());
            outcome_.steps_done = i + 1;
            if (observing) monitor_.observe(simulation_.time(), y_.data());
            if (sampling) sample(i + 1);
        }
    }

    void fail(Status status, long step, const std::string& where, const std::string& reason = "") {
        outcome_.status = name(status);
        outcome_.detail = where + " failed in step " + std::to_string(step + 1) + " of " + std::to_string(cell_.steps) +
                          ", from t = " + brief(time(step)) + " s";
        if (!reason.empty()) outcome_.detail += ": " + reason;
    }

    /// Names the first quantity that is not finite.
    std::string where_not_finite() {
        system_.read(y_.data(), states_.data());
        for (std::size_t i = 0; i < states_.size(); ++i) {
            const BodyState& s = states_[i];
            const std::pair<const char*, Real> sums[] = {
                {"x", s.x.sum()}, {"R", s.R.sum()}, {"v", s.v.sum()}, {"omega", s.omega.sum()}};
            for (const auto& [quantity, sum] : sums)
                if (!isfinite(sum)) return std::string("finiteness of ") + quantity + " of body \"" + names_[i] + "\"";
        }
        return "finiteness of the state";
    }

    std::vector<Column> columns() const {
        std::vector<Column> all = {{"t", "s"}};
        for (const std::string& body : names_) {
            const auto add = [&](const char* quantity, const char* unit, int count) {
                for (int i = 1; i <= count; ++i) all.push_back({body + "." + quantity + std::to_string(i), unit});
            };
            add("x", "m", 3);
            for (int i = 1; i <= 3; ++i)
                for (int j = 1; j <= 3; ++j) all.push_back({body + ".R" + std::to_string(i) + std::to_string(j), "1"});
            add("v", "m/s", 3);
            add("omega", "rad/s", 3);
        }
        for (const std::string& spring : names_of_torsion_springs(model_)) {
            all.push_back({"theta." + spring, "rad"});
            all.push_back({"turns." + spring, "1"});
        }
        for (Column& column : joint_forces_->columns()) all.push_back(std::move(column));
        for (Column& column : monitor_.columns()) all.push_back(std::move(column));
        return all;
    }

    void sample(long step) {
        if (step % (cell_.steps / cell_.samples) != 0) return;
        std::vector<Real> row = {time(step)};
        system_.read(y_.data(), states_.data());
        for (const BodyState& s : states_) {
            row.insert(row.end(), {s.x[0], s.x[1], s.x[2]});
            for (int i = 0; i < 3; ++i)
                for (int j = 0; j < 3; ++j) row.push_back(s.R(i, j));
            row.insert(row.end(), {s.v[0], s.v[1], s.v[2], s.omega[0], s.omega[1], s.omega[2]});
        }
        system_.read_angles(y_.data(), springs_.data());
        for (const SpringAngle& spring : springs_) row.insert(row.end(), {spring.theta, Real(spring.turns)});
        std::string line;
        const auto append = [&](const std::string& text) { line += (line.empty() ? "" : ",") + text; };
        for (const Real& x : row) append(to_text(x));
        std::vector<std::string> forces;
        joint_forces_->append_values(find_joint_forces(time(step)), forces);
        for (const std::string& text : forces) append(text);
        row.clear();
        monitor_.append_values(row);
        for (const Real& x : row) append(isfinite(x) ? to_text(x) : "");
        if (samples_) samples_->add(line);
    }

    bool find_joint_forces(const Real& t) { return joint_forces_->find(t, y_.data(), simulation_.multipliers()); }

    void finish(const Reference* reference) {
        const Real t = time(outcome_.steps_done);
        outcome_.t_reached = to_double(t);
        outcome_.cost.evaluations = cell_.timed ? evaluations_ : system_.evaluations();
        outcome_.cost.projection_iterations = simulation_.projection().iterations();
        if (outcome_.status == "ok" && !cell_.timed) {
            const bool found = find_joint_forces(t);
            bool known = found;
            if (known && outcome_.constraints.has_redundant_rows()) {  // they are not unique
                for (const Real& x : joint_forces_->multipliers())
                    outcome_.constraints.least_norm.push_back(to_number(x));
                known = false;
            }
            system_.read(y_.data(), states_.data());
            system_.read_angles(y_.data(), springs_.data());
            outcome_.final =
                to_report(t, states_, names_, known ? joint_forces_->multipliers() : std::vector<Real>(), springs_);
            if (found) joint_forces_->report(*outcome_.final);
            if (reference) add_errors(*reference, known);
            outcome_.lost = conservation_->lost(y_.data());
        }
        outcome_.cost.output_evaluations += monitor_.evaluations();
        if (joint_forces_) outcome_.cost.output_evaluations += joint_forces_->evaluations();
        // A run that failed in its first step has measured only its start.
        const bool finished = outcome_.status == "ok";
        if (!finished && outcome_.steps_done == 0) return;
        for (auto& metric : monitor_.metrics(finished)) outcome_.metrics.push_back(std::move(metric));
    }

    /// Past the horizon of a reference, a distance from it is meaningful only if far above the uncertainty.
    bool is_known(const Reference& reference, const std::string& metric, const Real& error) const {
        if (cell_.t_end <= reference.horizon) return true;
        const auto uncertainty = reference.error.find(metric);
        return uncertainty != reference.error.end() && error > 100 * from_number(uncertainty->second);
    }

    void add_errors(const Reference& reference, bool multipliers_known) {
        if (reference.state.bodies.empty()) return;
        const auto add = [&](const std::string& metric, const Real& value) {
            if (isfinite(value) && matches_any(cell_.metrics, metric) && is_known(reference, metric, value))
                outcome_.metrics.emplace_back(metric, to_number(value));
        };
        const Distance d = distance(states_, from_report(reference.state));
        add("error.position", d.position);
        add("error.rotation", d.rotation);
        add("error.velocity", d.velocity);
        add("error.omega", d.omega);
        std::vector<Real> exact;
        for (const Number& row : reference.state.multipliers) exact.push_back(from_number(row));
        const std::vector<Real>& multipliers = joint_forces_->multipliers();
        if (!multipliers_known || exact.size() != multipliers.size()) return;
        const auto rows = system_.constraint_rows();
        std::map<std::string, Number> errors;
        add_multiplier_errors(rows, multiplier_distance(rows, multipliers, exact), errors);
        for (const auto& [metric, value] : errors) add(metric, from_number(value));
    }

    const Cell& cell_;
    double heap_before_;
    Simulation simulation_;
    const Model& model_;
    System& system_;
    const std::vector<Real>& y_;
    Monitor monitor_;
    std::optional<JointForces> joint_forces_;   // not of a timed cell, which would count its memory
    std::optional<Conservation> conservation_;  // nor this
    Real t_end_, h_;
    std::vector<BodyState> states_;
    std::vector<SpringAngle> springs_;
    std::vector<std::string> names_;
    long evaluations_ = 0;
    SampleSink* samples_ = nullptr;
    Outcome outcome_;
};

}  // namespace

std::string why_skipped(const Cell& cell) {
    const Model model = problem(cell.problem).build(Parameters(cell.parameters));
    check_start(model);
    const Method& entry = method(cell.method);
    const ProjectionMethod& projector = projection(cell.projection);
    if (const std::string reason = formulation(cell.formulation).why_not(model); !reason.empty()) return reason;
    if (!applies(entry.description.formulations, cell.formulation))
        return only_for(cell.method, entry.description.formulations);
    if (const std::string reason = entry.factory.why_not(cell.options); !reason.empty()) return reason;
    if (cell.projection == "none") return "";
    if (entry.description.own_multipliers)
        return cell.method + " meets the constraints by itself, so that nothing is left to project";
    if (!applies(projector.description.formulations, cell.formulation))
        return only_for("projection " + cell.projection, projector.description.formulations);
    const auto system = make_system(model, cell.formulation);
    if (projector.description.ambient && !system->has_ambient_jacobian())
        return "projection " + cell.projection + " takes spherical joints only";
    return system->constraints() == 0 ? "there is no constraint to project onto in formulation " + cell.formulation
                                      : "";
}

Outcome run_cell(const Cell& cell, const Reference* reference, const std::stop_token& stop, SampleSink* samples) {
    return Run(cell).execute(reference, stop, samples);
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
