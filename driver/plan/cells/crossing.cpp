// SPDX-License-Identifier: BSD-3-Clause
#include "driver/plan/cells/crossing.hpp"

#include <fmt/format.h>

#include <set>

#include "driver/plan/cells/identify.hpp"
#include "driver/plan/cost.hpp"
#include "driver/plan/metric_names.hpp"
#include "records/begin.hpp"
#include "records/json/diagnostics.hpp"
#include "records/json/writer.hpp"
#include "support/hash.hpp"

namespace kreisel {

namespace {

// What the cells of a config want of references, and of their samples.
struct WantedReferences {
    explicit WantedReferences(const Config& config)
        : samples(asks_for_largest_errors(config.metrics) ? config.samples : 0),
          any(samples > 0 || asks_for_errors(config.metrics)) {}
    long samples;
    bool any;
};

// A reference that knows samples is another one than that which does not.
std::string add_reference(const Cell& cell, const ProblemPoint& problem, const SystemSummary& system, long samples,
                          Plan& plan) {
    ObjectWriter object;
    object.member("problem", json_text(cell.problem)).member("parameters", problem.parameters_text());
    if (cell.begin) { object.member("begin", json_begin(*cell.begin)); }
    object.member("t_end", json_number(cell.t_end));
    if (samples > 0) { object.member("samples", fmt::format("{}", samples)); }
    const std::string content = object.text();
    PlannedReference reference{cell.problem, problem.parameters(), cell.t_end, samples, content};
    reference.begin = cell.begin;
    reference.weight = cost_of(reference, system);
    plan.references.insert({hash_text(content), std::move(reference)});
    return hash_text(content);
}

// Constant steps, or a tolerance.
struct Stepping {
    long steps = 0;
    double tolerance = 0;
    std::string skip_reason = "";
};

// What of the config's steps and tolerances a method takes; if it takes none of them, all, with the reason.
std::vector<Stepping> steppings_of(const MethodDescription& method, const Config& config) {
    const bool takes_steps = !method.own_control, takes_tolerances = method.own_control || method.estimate > 0;
    const bool none = (!takes_steps || config.steps.empty()) && (!takes_tolerances || config.tolerances.empty());
    std::vector<Stepping> all;
    for (const long steps : config.steps) {
        if (takes_steps) { all.push_back({.steps = steps}); }
        if (none) { all.push_back({.steps = steps, .skip_reason = "it chooses its steps itself, to a tolerance"}); }
    }
    for (const double tolerance : config.tolerances) {
        if (takes_tolerances) { all.push_back({.tolerance = tolerance}); }
        if (none) {
            all.push_back({.tolerance = tolerance,
                           .skip_reason = "it has no estimate of its error to choose steps by: constant steps only"});
        }
    }
    return all;
}

// A method under its options with a projection under its own, in one precision.
struct Combination {
    const OptionedEntry& method;
    const OptionedEntry& projection;
    const std::string& precision;
    MethodDescription described;
    std::vector<Stepping> steppings;
};

std::vector<Combination> combinations_of(const Config& config, const Engines& engines) {
    std::vector<Combination> all;
    for (const OptionedEntry& method : config.methods) {
        for (const OptionedEntry& projection : config.projections) {
            for (const std::string& precision : config.precisions) {
                MethodDescription described = engines.of(precision).method(method.name, method.options);
                const auto steppings = steppings_of(described, config);
                all.push_back({method, projection, precision, std::move(described), steppings});
            }
        }
    }
    return all;
}

// What of a run depends on the problem.
struct OfProblem {
    PlannedSystems::Shared system;
    std::string skip_reason = "", reference = "";
    bool operator==(const OfProblem&) const = default;
};

// The runs of one entry's problems in one formulation with one combination. Most of these problems differ in nothing
// but their parameters, and share the run of the one before.
class RunsOfEntry {
  public:
    RunsOfEntry(const Config& config, const ProblemPoint& first, const std::string& formulation,
                const Combination& combination)
        : run_(begun(config, first, formulation, combination)), names_(run_) {}

    const CellNaming& names() const { return names_; }
    /// But for its parameters and steps.
    const Cell& cell() const { return run_.cell; }
    std::shared_ptr<const PlannedRun> run(const OfProblem& of, bool of_tolerance) {
        std::shared_ptr<const PlannedRun>& last = of_tolerance ? of_tolerance_ : of_steps_;
        if (last && OfProblem{last->system, last->skip_reason, last->reference} == of) { return last; }
        PlannedRun run = run_;
        run.system = of.system;
        run.skip_reason = of.skip_reason;
        run.reference = of.reference;
        return last = std::make_shared<const PlannedRun>(std::move(run));
    }

  private:
    static PlannedRun begun(const Config& config, const ProblemPoint& first, const std::string& formulation,
                            const Combination& combination) {
        const Cell cell = {.problem = first.name(),
                           .parameters = {},
                           .formulation = formulation,
                           .method = combination.method.name,
                           .options = combination.method.options,
                           .projection = combination.projection.name,
                           .projection_options = combination.projection.options,
                           .begin = config.begin,
                           .t_end = config.t_end,
                           .controller = config.controller,
                           .dense = config.dense,
                           .samples = config.samples,
                           .metrics = config.metrics,
                           .timed = config.is_timed(),
                           .repeated = config.is_repeated()};
        return {.problems = first.series(),
                .system = nullptr,
                .cell = cell,
                .identity = identity_of(cell, first.series_label(), combination.precision, combination.described.order),
                .skip_reason = "",
                .reference = ""};
    }

    PlannedRun run_;
    CellNaming names_;
    std::shared_ptr<const PlannedRun> of_steps_, of_tolerance_;
};

class Crossing {
  public:
    Crossing(const Engines& engines, Diagnostics& sink, Plan& plan)
        : engines_(engines),
          sink_(sink),
          plan_(plan),
          wanted_(plan.config),
          combinations_(combinations_of(plan.config, engines)) {}

    void cross() {
        const Config& config = plan_.config;
        std::size_t cells = 0;
        for (const Combination& combination : combinations_) { cells += combination.steppings.size(); }
        plan_.cells.reserve(cells * config.formulations.size() * config.problems.size());
        for (std::size_t i = 0; i < config.problems.size(); ++i) {
            const ProblemPoint& problem = config.problems[i];
            if (i == 0 || config.problems[i - 1].series() != problem.series()) { begin_entry(problem); }
            add_problem(problem, i);
        }
    }

  private:
    void begin_entry(const ProblemPoint& first) {
        runs_.clear();
        for (const std::string& formulation : plan_.config.formulations) {
            for (const Combination& combination : combinations_) {
                runs_.emplace_back(plan_.config, first, formulation, combination);
            }
        }
    }

    void add_problem(const ProblemPoint& problem, std::size_t index) {
        const std::string parameters = problem.parameters_text();
        const std::size_t formulations = plan_.config.formulations.size();
        auto runs = runs_.begin();
        for (std::size_t j = 0; j < formulations; ++j) {
            const PlannedSystems::Shared& system = plan_.systems.at(index * formulations + j);
            for (const Combination& combination : combinations_) {
                add_cells(problem, parameters, system, combination, *runs++);
            }
        }
    }

    // Whether a cell applies depends on its having a tolerance, not on which.
    void add_cells(const ProblemPoint& problem, const std::string& parameters, const PlannedSystems::Shared& system,
                   const Combination& combination, RunsOfEntry& runs) {
        std::shared_ptr<const PlannedRun> of_steps, of_tolerances;
        for (const Stepping& stepping : combination.steppings) {
            const bool to_tolerance = stepping.tolerance > 0;
            std::shared_ptr<const PlannedRun>& run = to_tolerance ? of_tolerances : of_steps;
            if (!run) { run = runs.run(of_problem(runs.cell(), problem, system, stepping, combination), to_tolerance); }
            PlannedCell planned{run, problem.point(), runs.names().name(parameters, stepping.steps, stepping.tolerance),
                                stepping.steps, stepping.tolerance};
            planned.weight = cost_of(planned, combination.described, *system);
            plan_.cells.push_back(std::move(planned));
        }
    }

    OfProblem of_problem(const Cell& cell, const ProblemPoint& problem, const PlannedSystems::Shared& system,
                         const Stepping& stepping, const Combination& combination) {
        OfProblem of{system};
        of.skip_reason = system->skip_reason.empty() ? stepping.skip_reason : system->skip_reason;
        if (of.skip_reason.empty()) { of.skip_reason = ask(cell, problem, stepping, combination); }
        if (of.skip_reason.empty() && wanted_.any) {
            of.reference = add_reference(cell, problem, *system, wanted_.samples, plan_);
        }
        return of;
    }

    std::string ask(Cell cell, const ProblemPoint& problem, const Stepping& stepping, const Combination& combination) {
        cell.parameters = problem.parameters();
        cell.steps = stepping.steps;
        cell.tolerance = stepping.tolerance;
        try {
            return engines_.of(combination.precision).skip_reason(cell);
        } catch (const ParameterError& error) {
            report(problem.parameter_pointer(error.path), error.what(), Rule::model);
        } catch (const OptionError& error) {
            const bool of_method = cell.options.contains(error.option);
            const OptionedEntry& owner = of_method ? combination.method : combination.projection;
            report(pointer_below(owner.pointer, error.option), error.what(), Rule::options);
        }
        return "";
    }

    void report(const std::string& pointer, const std::string& what, Rule rule) {
        if (reported_.insert(pointer + what).second) { sink_.add_sentence(pointer, what, rule); }
    }

    const Engines& engines_;
    Diagnostics& sink_;
    Plan& plan_;
    const WantedReferences wanted_;
    const std::vector<Combination> combinations_;
    std::vector<RunsOfEntry> runs_;  // of the entry at hand, by formulation and combination
    std::set<std::string> reported_;
};

}  // namespace

void cross_axes(const Engines& engines, Diagnostics& sink, Plan& plan) { Crossing(engines, sink, plan).cross(); }

}  // namespace kreisel
