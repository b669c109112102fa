// SPDX-License-Identifier: BSD-3-Clause
#include "driver/plan/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "driver/plan/figures.hpp"
#include "driver/plan/metric_names.hpp"
#include "records/json/writer.hpp"
#include "records/metrics/catalogue.hpp"
#include "support/hash.hpp"
#include "support/nearest.hpp"
#include "support/pattern.hpp"

namespace kreisel {

namespace {

constexpr double quad_cost = 40;  // relative to double, roughly: used only to order the work

// The place of a parameter error: below "parameters" where the config writes them, at the entry otherwise.
std::string parameter_pointer(const ProblemEntry& problem, const std::string& path) {
    return problem.pointer + "/parameters" + path;
}

// For a name that does not exist, the nearest one that does.
std::string suggestion(const ParameterError& error) {
    const std::string nearest = error.known.empty() ? "" : nearest_name(error.written, error.known);
    return nearest.empty() ? "" : "; did you mean " + in_quotes(nearest) + "?";
}

// Builds the system of each problem in each formulation and precision; an inadmissible start or inertia is an error.
void summarise(const Config& config, const Engines& engines, Diagnostics& sink, Plan& plan) {
    for (const ProblemEntry& problem : config.problems) {
        std::set<std::string> said;
        for (const std::string& formulation : config.formulations) {
            for (const std::string& precision : config.precisions) {
                try {
                    SystemSummary summary =
                        engines.of(precision).summary(problem.name, problem.parameters, formulation);
                    for (const std::string& warning : summary.warnings) {
                        if (said.insert(warning).second) {
                            plan.warnings.push_back(fmt::format("{}: {}", problem.label, warning));
                        }
                    }
                    plan.systems.insert_or_assign({problem.label, formulation}, std::move(summary));
                } catch (const ParameterError& error) {
                    if (said.insert(error.path + error.what()).second) {
                        sink.add_sentence(parameter_pointer(problem, error.path), error.what() + suggestion(error));
                    }
                }
            }
        }
    }
}

// All metrics that the problems of the plan have.
std::vector<std::string> known_metrics(const Plan& plan) {
    std::set<std::string> integrals;
    for (const auto& [key, summary] : plan.systems) {
        for (const IntegralDescription& integral : summary.integrals) { integrals.insert(integral.name); }
    }
    return metric_names({integrals.begin(), integrals.end()});
}

// Whether there are rows of the kind that a metric is of.
bool has_rows_of(const ConstraintSummary& constraints, MetricRows rows) {
    switch (rows) {
        case MetricRows::any:
            return true;
        case MetricRows::lengths:
            return constraints.rows > constraints.directions;
        case MetricRows::directions:
            return constraints.directions > 0;
    }
    return false;
}

// Whether some cell can measure a metric: metrics of constraints need constraints, and those of multipliers unique
// ones.
bool can_be_measured(const Plan& plan, const std::string& name) {
    const MetricDescription* metric = find_metric(name);
    return std::any_of(plan.systems.begin(), plan.systems.end(), [&](const auto& entry) {
        const SystemSummary& system = entry.second;
        if (!system.skip_reason.empty()) { return false; }
        if (metric == nullptr) {
            const auto names = metric_names(names_of(system.integrals));
            return std::find(names.begin(), names.end(), name) != names.end();
        }
        if (metric->level == MetricLevel::multipliers && system.constraints.has_redundant_rows()) { return false; }
        return has_rows_of(system.constraints, metric->rows);
    });
}

// A plain name must exist; a pattern that matches nothing and a metric that cannot be measured here give warnings.
void check_metrics(const Document& document, const std::vector<std::string>& names, Diagnostics& sink, Plan& plan) {
    if (!plan.config.metrics_given) { return; }
    std::vector<std::string> suggestions = names;
    suggestions.insert(suggestions.end(), {"error.*", "defect.*", "invariant.*"});
    for (std::size_t i = 0; i < plan.config.metrics.size(); ++i) {
        const std::string& pattern = plan.config.metrics[i];
        const bool plain = pattern.find('*') == std::string::npos;
        const std::string pointer = fmt::format("/metrics/{}", i);
        const auto fits = [&](const std::string& name) { return matches(pattern, name); };
        if (plain && std::none_of(names.begin(), names.end(), fits)) {
            sink.mismatch(pointer, document.value["metrics"][i],
                          "a metric of these problems, or a pattern that fits one (see kreisel list metrics)",
                          nearest_name(pattern, names));
        } else if (std::none_of(names.begin(), names.end(),
                                [&](const auto& name) { return fits(name) && can_be_measured(plan, name); })) {
            const std::string nearest = plain ? "" : nearest_name(pattern, suggestions);
            plan.warnings.push_back(fmt::format("{}: {} fits no metric that a cell of this config can measure{}",
                                                pointer, in_quotes(pattern),
                                                nearest.empty() ? "" : "; did you mean " + in_quotes(nearest) + "?"));
        }
    }
}

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
    Crossing(const Document& document, const Engines& engines, Diagnostics& sink, Plan& plan)
        : document_(document), engines_(engines), sink_(sink), plan_(plan) {}

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
                planned.cell = {problem.name,   problem.parameters, formulation,        method.name,
                                method.options, projection.name,    projection.options, config.t_end,
                                steps,          config.samples,     config.metrics,     config.is_timed()};
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
            report(parameter_pointer(problem, error.path), error.what());
        } catch (const OptionError& error) {
            const OptionedEntry& owner = planned.cell.options.contains(error.option) ? method : projection;
            report(pointer_below(owner.pointer, error.option), error.what());
        }
        return "";
    }

    void report(const std::string& pointer, const std::string& what) {
        if (reported_.insert(pointer + what).second) { sink_.add_sentence(pointer, what); }
    }

    const Document& document_;
    const Engines& engines_;
    Diagnostics& sink_;
    Plan& plan_;
    std::set<std::string> reported_;
};

void warn(Plan& plan) {
    if (plan.skipped() == plan.cells.size()) {
        plan.warnings.emplace_back("every cell of this config is skipped: nothing will be computed");
    }
    if (plan.config.kind == "trajectory" && plan.config.samples == 0) {
        plan.warnings.emplace_back("a trajectory without \"output\": {\"samples\": ...} keeps its final state only");
    }
}

}  // namespace

std::size_t Plan::skipped() const {
    return static_cast<std::size_t>(
        std::count_if(cells.begin(), cells.end(), [](const PlannedCell& cell) { return !cell.skip_reason.empty(); }));
}

Plan make_plan(const Document& document, const Config& config, const Engines& engines) {
    Diagnostics sink(document);
    Plan plan;
    plan.config = config;
    summarise(config, engines, sink, plan);
    sink.raise();
    const auto metrics = known_metrics(plan);
    check_metrics(document, metrics, sink, plan);
    check_figures(document, plan, metrics, sink);
    Crossing(document, engines, sink, plan).cross();
    sink.raise();
    warn(plan);
    return plan;
}

Plan plan_of(const Document& document, const Engines& engines) {
    return make_plan(document, read_config(document, Registry(engines.binary64)), engines);
}

}  // namespace kreisel
