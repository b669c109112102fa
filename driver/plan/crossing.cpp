// SPDX-License-Identifier: BSD-3-Clause
#include "driver/plan/crossing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "driver/plan/metric_names.hpp"
#include "records/json/writer.hpp"
#include "support/hash.hpp"

namespace kreisel {

namespace {

constexpr double quad_cost = 40;  // relative to double, roughly: used only to order the work

void name_reference(PlannedCell& planned, Plan& plan) {
    const Cell& cell = planned.cell;
    const std::string content = ObjectWriter()
                                    .member("problem", json_text(cell.problem))
                                    .member("parameters", json_value(cell.parameters))
                                    .member("t_end", json_number(cell.t_end))
                                    .text();
    planned.reference = hash_text(content);
    plan.references.insert({planned.reference, {cell.problem, cell.parameters, cell.t_end, content}});
}

// Everything that determines the numbers, with keys and lists in a fixed order; not the label.
std::string content_of(const PlannedCell& planned) {
    const Cell& cell = planned.cell;
    std::vector<std::string> metrics = cell.metrics;
    std::sort(metrics.begin(), metrics.end());
    ObjectWriter object;
    object.member("problem", json_text(cell.problem))
        .member("parameters", json_value(cell.parameters))
        .member("formulation", json_text(cell.formulation))
        .member("method", json_text(cell.method))
        .member("options", json_value(cell.options))
        .member("projection", json_text(cell.projection))
        .member("projection_options", json_value(cell.projection_options))
        .member("precision", json_text(planned.precision))
        .member("t_end", json_number(cell.t_end))
        .member("steps", fmt::format("{}", cell.steps))
        .member("samples", fmt::format("{}", cell.samples))
        .member("metrics", json_value(metrics));
    if (cell.timed) { object.member("timed", "true"); }
    return object.text();
}

CellIdentity identity_of(const PlannedCell& planned, const Order& order) {
    const Cell& cell = planned.cell;
    return {planned.hash,
            cell.problem,
            planned.label,
            planned.series,
            parse_exactly(json_value(cell.parameters)),
            cell.formulation,
            cell.method,
            cell.options,
            order,
            cell.projection,
            cell.projection_options,
            planned.precision,
            cell.steps,
            cell.t_end / static_cast<double>(cell.steps),
            cell.t_end};
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
            for (const long steps : config.steps) {
                PlannedCell planned;
                planned.cell = {.problem = problem.name,
                                .parameters = problem.parameters,
                                .formulation = formulation,
                                .method = method.name,
                                .options = method.options,
                                .projection = projection.name,
                                .projection_options = projection.options,
                                .t_end = config.t_end,
                                .steps = steps,
                                .samples = config.samples,
                                .metrics = config.metrics,
                                .timed = config.is_timed()};
                planned.series = problem.series;
                planned.label = problem.label;
                planned.precision = precision;
                add(std::move(planned), problem, method, projection);
            }
        }
    }

    void add(PlannedCell planned, const ProblemEntry& problem, const OptionedEntry& method,
             const OptionedEntry& projection) {
        const SystemSummary& system = plan_.systems.at({problem.label, planned.cell.formulation});
        planned.hash = hash_text(content_of(planned));
        const Engine& engine = engines_.of(planned.precision);
        planned.identity = identity_of(planned, engine.declared_order(method.name, method.options));
        planned.skip_reason =
            system.skip_reason.empty() ? ask(planned, problem, method, projection) : system.skip_reason;
        planned.weight =
            static_cast<double>(planned.cell.steps) * std::max(1, system.bodies) * (planned.quad() ? quad_cost : 1);
        if (planned.skip_reason.empty() && asks_for_errors(planned.cell.metrics)) { name_reference(planned, plan_); }
        plan_.cells.push_back(std::move(planned));
    }

    std::string ask(const PlannedCell& planned, const ProblemEntry& problem, const OptionedEntry& method,
                    const OptionedEntry& projection) {
        try {
            return engines_.of(planned.precision).skip_reason(planned.cell);
        } catch (const ParameterError& error) {
            report(problem.parameter_pointer(error.path), error.what());
        } catch (const OptionError& error) {
            const OptionedEntry& owner = planned.cell.options.contains(error.option) ? method : projection;
            report(pointer_below(owner.pointer, error.option), error.what());
        }
        return "";
    }

    void report(const std::string& pointer, const std::string& what) {
        if (reported_.insert(pointer + what).second) { sink_.add_sentence(pointer, what); }
    }

    const Engines& engines_;
    Diagnostics& sink_;
    Plan& plan_;
    std::set<std::string> reported_;
};

}  // namespace

void cross_axes(const Engines& engines, Diagnostics& sink, Plan& plan) { Crossing(engines, sink, plan).cross(); }

}  // namespace kreisel
