// SPDX-License-Identifier: BSD-3-Clause
#include "driver/plan/crossing.hpp"

#include <fmt/format.h>

#include <set>

#include "driver/plan/cost.hpp"
#include "driver/plan/identify.hpp"
#include "driver/plan/metric_names.hpp"
#include "records/json/diagnostics.hpp"
#include "records/json/writer.hpp"
#include "support/hash.hpp"

namespace kreisel {

namespace {

// A reference that knows samples is another one than that which does not.
std::string add_reference(const Cell& cell, const SystemSummary& system, Plan& plan) {
    const long samples = asks_for_largest_errors(cell.metrics) ? cell.samples : 0;
    if (samples == 0 && !asks_for_errors(cell.metrics)) { return ""; }
    ObjectWriter object;
    object.member("problem", json_text(cell.problem))
        .member("parameters", json_value(cell.parameters))
        .member("t_end", json_number(cell.t_end));
    if (samples > 0) { object.member("samples", fmt::format("{}", samples)); }
    const std::string content = object.text();
    PlannedReference reference{cell.problem, cell.parameters, cell.t_end, samples, content};
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

class Crossing {
  public:
    Crossing(const Engines& engines, Diagnostics& sink, Plan& plan) : engines_(engines), sink_(sink), plan_(plan) {}

    void cross() {
        const Config& config = plan_.config;
        for (const ProblemEntry& problem : config.problems) {
            for (const std::string& formulation : config.formulations) {
                for (const OptionedEntry& method : config.methods) {
                    for (const OptionedEntry& projection : config.projections) {
                        add_runs(problem, formulation, method, projection);
                    }
                }
            }
        }
    }

  private:
    void add_runs(const ProblemEntry& problem, const std::string& formulation, const OptionedEntry& method,
                  const OptionedEntry& projection) {
        const Config& config = plan_.config;
        for (const std::string& precision : config.precisions) {
            const MethodDescription described = engines_.of(precision).method(method.name, method.options);
            const Cell cell = {.problem = problem.name,
                               .parameters = problem.parameters,
                               .formulation = formulation,
                               .method = method.name,
                               .options = method.options,
                               .projection = projection.name,
                               .projection_options = projection.options,
                               .t_end = config.t_end,
                               .controller = config.controller,
                               .dense = config.dense,
                               .samples = config.samples,
                               .metrics = config.metrics,
                               .timed = config.is_timed(),
                               .repeated = config.is_repeated()};
            const PlannedRun run{cell, identity_of(cell, problem, precision, described.order), "", ""};
            add_cells(run, described, problem, method, projection);
        }
    }

    // Whether a cell applies depends on its having a tolerance, not on which.
    void add_cells(const PlannedRun& run, const MethodDescription& described, const ProblemEntry& problem,
                   const OptionedEntry& method, const OptionedEntry& projection) {
        const SystemSummary& system = plan_.systems.at({problem.label, run.cell.formulation});
        const CellNaming names(run);
        std::shared_ptr<const PlannedRun> of_steps, of_tolerances;
        for (const Stepping& stepping : steppings_of(described, plan_.config)) {
            std::shared_ptr<const PlannedRun>& shared = stepping.tolerance > 0 ? of_tolerances : of_steps;
            PlannedCell planned{shared, names.name(stepping.steps, stepping.tolerance), stepping.steps,
                                stepping.tolerance};
            if (!shared) {
                planned.run = std::make_shared<const PlannedRun>(run);
                PlannedRun complete = run;
                complete.skip_reason = system.skip_reason.empty() ? stepping.skip_reason : system.skip_reason;
                if (complete.skip_reason.empty()) { complete.skip_reason = ask(planned, problem, method, projection); }
                if (complete.skip_reason.empty()) { complete.reference = add_reference(run.cell, system, plan_); }
                planned.run = shared = std::make_shared<const PlannedRun>(std::move(complete));
            }
            planned.weight = cost_of(planned, described, system);
            plan_.cells.push_back(std::move(planned));
        }
    }

    std::string ask(const PlannedCell& planned, const ProblemEntry& problem, const OptionedEntry& method,
                    const OptionedEntry& projection) {
        try {
            return engines_.of(planned.precision()).skip_reason(planned.cell());
        } catch (const ParameterError& error) {
            report(problem.parameter_pointer(error.path), error.what(), Rule::model);
        } catch (const OptionError& error) {
            const OptionedEntry& owner = planned.run->cell.options.contains(error.option) ? method : projection;
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
    std::set<std::string> reported_;
};

}  // namespace

void cross_axes(const Engines& engines, Diagnostics& sink, Plan& plan) { Crossing(engines, sink, plan).cross(); }

}  // namespace kreisel
