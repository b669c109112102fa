// SPDX-License-Identifier: BSD-3-Clause
#include "driver/cli/catalogue.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "driver/cli/configs.hpp"
#include "driver/cli/kinds.hpp"
#include "driver/cli/rows.hpp"
#include "driver/config/options.hpp"
#include "driver/config/values.hpp"
#include "driver/plan/metric_names.hpp"
#include "records/json/model_keys.hpp"
#include "records/json/writer.hpp"
#include "records/metrics/catalogue.hpp"
#include "support/errors.hpp"
#include "support/nearest.hpp"

namespace kreisel {

namespace {

std::string order_text(const Order& order) {
    if (order == Order(order.configuration)) { return fmt::format("order {}", order.configuration); }
    return fmt::format("order {} (configuration), {} (velocity), {} (multipliers)", order.configuration, order.velocity,
                       order.multipliers);
}

std::vector<NamedText> method_rows(const std::vector<MethodDescription>& methods) {
    std::vector<NamedText> rows;
    rows.reserve(methods.size());
    for (const MethodDescription& method : methods) {
        rows.emplace_back(method.name, fmt::format("{}; {}", order_text(method.order), method.summary));
    }
    return rows;
}

std::vector<NamedText> metric_rows() {
    std::vector<NamedText> rows;
    for (const MetricDescription& metric : metric_catalogue()) {
        rows.emplace_back(metric.name, fmt::format("{} [{}]", metric.summary, metric.unit));
    }
    rows.emplace_back("defect.<name>.final", "the defect at the end");
    for (const InvariantSuffix& suffix : invariant_suffixes()) {
        rows.emplace_back("invariant.<integral>" + suffix.name, fmt::format("{} [{}]", suffix.summary, suffix.unit));
    }
    return rows;
}

void print_sources(std::ostream& out, const std::vector<std::string>& keys) {
    if (!keys.empty()) { fmt::print(out, "Sources: {}\n", fmt::join(keys, ", ")); }
}

void print_options(std::ostream& out, const std::vector<OptionDescription>& options) {
    std::vector<NamedText> rows;
    rows.reserve(options.size());
    for (const OptionDescription& option : options) {
        rows.emplace_back(option.name, fmt::format("{}: {} (default {})", option.summary, allowed_values(option),
                                                   json_value(option.standard)));
    }
    if (rows.empty()) {
        fmt::print(out, "Options: none\n");
    } else {
        print_rows(out, "Options", rows);
    }
}

void print_integrals(std::ostream& out, const SystemSummary& summary) {
    for (const IntegralDescription& integral : summary.integrals) {
        fmt::print(out, "    invariant.{} [{}]: {}\n", integral.name, integral.unit, integral.reason);
    }
}

// "30 of rank 29 (row 5 of joint 5 follows from others), condition 12.3".
std::string constraints_of(const ConstraintSummary& constraints) {
    std::string text = fmt::format("{}", constraints.rows);
    if (constraints.has_redundant_rows()) {
        text += fmt::format(" of rank {} ({} follow from others)", constraints.rank,
                            fmt::join(constraints.redundant, ", "));
    }
    if (constraints.condition) { text += fmt::format(", condition {:.3g}", *constraints.condition); }
    return text;
}

// A key in brackets is not required.
std::string keys_text(const ElementType& type) {
    std::string text;
    for (const ElementKey& key : type.keys) {
        const auto second = [&](const Alternative& two) { return two.other == key.name; };
        if (std::any_of(type.alternatives.begin(), type.alternatives.end(), second)) { continue; }
        std::string shown = key.name;
        bool required = key.required;
        for (const auto& [one, other, needed] : type.alternatives) {
            if (one == key.name) { shown += "|" + other, required = needed; }
        }
        text += (text.empty() ? "" : ", ") + (required ? shown : "[" + shown + "]");
    }
    return text;
}

// The format of the entries of its lists.
void print_elements(std::ostream& out, const ProblemDescription& problem) {
    std::vector<NamedText> meanings;
    std::set<std::string> told;
    for (const ParameterDescription& parameter : problem.parameters) {
        if (!has_elements(parameter.kind)) { continue; }
        const ElementList& list = elements_of(parameter.kind);
        std::vector<NamedText> types;
        for (const ElementType& type : list.types) {
            types.emplace_back(type.name, fmt::format("{}; {}", keys_text(type), type.summary));
            for (const ElementKey& key : type.keys) {
                if (told.insert(key.name).second) { meanings.emplace_back(key.name, meaning_of_key(key.name)); }
            }
        }
        const std::string standard = list.standard.empty() ? "" : ", by default " + in_quotes(list.standard);
        print_rows(out,
                   fmt::format("An entry of {} has a \"type\"{}, and its keys ([optional], one|other)",
                               in_quotes(parameter.name), standard),
                   types);
    }
    if (!meanings.empty()) { print_rows(out, "Keys of entries", meanings); }
}

// The values used instead of defaults for required parameters.
void print_demonstration(std::ostream& out, const ProblemDescription& problem) {
    if (problem.demonstration.empty()) { return; }
    std::vector<NamedText> rows;
    for (const auto& [name, value] : problem.demonstration) { rows.emplace_back(name, json_value(value)); }
    print_rows(out, fmt::format("Demonstration ({})", problem.demonstration_config), rows);
}

void describe_problem(const Engine& engine, const ProblemDescription& problem, std::ostream& out) {
    fmt::print(out, "{}: {}\n", problem.name, problem.summary);
    print_sources(out, problem.cites);
    fmt::print(out, "Closed form: {}\n", problem.closed_form ? "yes" : "none");
    std::vector<NamedText> rows;
    for (const ParameterDescription& parameter : problem.parameters) {
        const std::string unit = parameter.unit.empty() ? "" : " [" + parameter.unit + "]";
        const std::string standard = parameter.required ? "required" : "default " + json_value(parameter.standard);
        rows.emplace_back(parameter.name,
                          fmt::format("{}{}: {} ({})", parameter.summary, unit, expectation(parameter.kind), standard));
    }
    print_rows(out, "Parameters", rows);
    print_elements(out, problem);
    print_demonstration(out, problem);
    fmt::print(out, "With {} parameters, formulated on\n", problem.demonstration.empty() ? "default" : "these");
    for (const FormulationDescription& formulation : engine.formulations()) {
        const SystemSummary summary = engine.summary(problem.name, demonstration_parameters(problem), formulation.name);
        if (!summary.skip_reason.empty()) {
            fmt::print(out, "  {}: not possible: {}\n", formulation.name, summary.skip_reason);
            continue;
        }
        fmt::print(out, "  {}: bodies {}, velocity coordinates {}, constraint rows {}; first integrals:\n",
                   formulation.name, summary.bodies, summary.velocities, constraints_of(summary.constraints));
        print_integrals(out, summary);
    }
}

// Whether steps can be chosen to a tolerance.
std::string control_text(const MethodDescription& method) {
    if (method.own_control) { return "; chooses its steps itself, to a tolerance only"; }
    return method.estimate > 0 ? fmt::format("; steps to a tolerance, by an error estimate O(h^{})", method.estimate)
                               : "";
}

std::string solving_text(const MethodDescription& method) {
    if (method.implicit) { return "implicit, solved by Newton iteration"; }
    return fmt::format("explicit, solves of the dynamics per step: {}", method.stages);
}

void describe_method(const MethodDescription& method, std::ostream& out) {
    fmt::print(out, "{}: {}\n", method.name, method.summary);
    print_sources(out, method.cites);
    fmt::print(out, "{}; {}{}{}{}\n", order_text(method.order), solving_text(method), control_text(method),
               method.symmetric ? "; symmetric" : "",
               method.own_multipliers ? "; multipliers are its own unknowns, projections do not apply" : "");
    print_options(out, method.options);
}

// First integrals of the problems with their default parameters, or in their demonstration, by problem.
std::map<std::string, std::vector<IntegralDescription>> integrals_by_problem(const Engine& engine) {
    std::map<std::string, std::vector<IntegralDescription>> all;
    for (const ProblemDescription& problem : engine.problems()) {
        for (const FormulationDescription& formulation : engine.formulations()) {
            SystemSummary summary = engine.summary(problem.name, demonstration_parameters(problem), formulation.name);
            if (summary.skip_reason.empty()) { all[problem.name] = std::move(summary.integrals); }
        }
    }
    return all;
}

std::vector<std::string> integral_names(const Engine& engine) {
    std::set<std::string> names;
    for (const auto& [problem, integrals] : integrals_by_problem(engine)) {
        for (const IntegralDescription& integral : integrals) { names.insert(integral.name); }
    }
    return {names.begin(), names.end()};
}

// The family of a name such as invariant.energy.slope, and the problems that have it.
bool describe_invariant(const Engine& engine, const std::string& name, std::ostream& out) {
    for (const InvariantSuffix& suffix : invariant_suffixes()) {
        for (const auto& [problem, integrals] : integrals_by_problem(engine)) {
            for (const IntegralDescription& integral : integrals) {
                if (name != "invariant." + integral.name + suffix.name) { continue; }
                fmt::print(out, "{}: {} [{}; the integral in {}]\n", name, suffix.summary, suffix.unit, integral.unit);
                fmt::print(out, "A first integral of {}: {}\n", problem, integral.reason);
                return true;
            }
        }
    }
    return false;
}

bool describe_metric(const Engine& engine, const std::string& name, std::ostream& out) {
    const MetricDescription* metric = find_metric(name);
    if (metric == nullptr) { return describe_invariant(engine, name, out); }
    const bool final = name != metric->name;
    if (final && !(is_defect(*metric) && name.ends_with(".final"))) { return false; }
    fmt::print(out, "{}: {}{} [{}]\n", name, final ? "the same at the end: " : "", metric->summary, metric->unit);
    return true;
}

}  // namespace

const std::vector<std::string>& catalogue_topics() {
    static const std::vector<std::string> topics = [] {
        std::vector<std::string> all = {"problems", "methods", "projections", "formulations", "metrics"};
        all.insert(all.end(), kind_topics().begin(), kind_topics().end());
        all.emplace_back("configs");
        return all;
    }();
    return topics;
}

void list_topic(const Engine& engine, const std::string& topic, std::ostream& out) {
    const auto wanted = [&](const char* name) { return topic.empty() || topic == name; };
    if (wanted("problems")) { print_rows(out, "Problems", summaries(engine.problems())); }
    if (wanted("methods")) { print_rows(out, "Methods", method_rows(engine.methods())); }
    if (wanted("projections")) { print_rows(out, "Projections", summaries(engine.projections())); }
    if (wanted("formulations")) { print_rows(out, "Formulations", summaries(engine.formulations())); }
    if (wanted("metrics")) { print_rows(out, "Metrics", metric_rows()); }
    list_kinds(topic, out);
    if (wanted("configs")) { list_configs(out); }
}

void describe(const Engine& engine, const std::string& name, std::ostream& out) {
    const Registry registry(engine);
    if (const auto* problem = find_named(registry.problems, name)) { return describe_problem(engine, *problem, out); }
    if (const auto* method = find_named(registry.methods, name)) { return describe_method(*method, out); }
    if (const auto* projection = find_named(registry.projections, name)) {
        fmt::print(out, "{}: {}\n", projection->name, projection->summary);
        print_sources(out, projection->cites);
        return print_options(out, projection->options);
    }
    if (const auto* formulation = find_named(registry.formulations, name)) {
        fmt::print(out, "{}: {}\n", formulation->name, formulation->summary);
        return;
    }
    if (describe_metric(engine, name, out) || describe_kind(name, out)) { return; }
    auto names = metric_names(integral_names(engine));
    for (const auto& some : {names_of(registry.problems), names_of(registry.methods), names_of(registry.projections),
                             names_of(registry.formulations), names_of_kinds()}) {
        names.insert(names.end(), some.begin(), some.end());
    }
    const std::string nearest = nearest_name(name, names);
    throw UsageError(
        fmt::format("expected the name of a problem, method, projection, formulation, metric, kind, figure or table "
                    "(see kreisel list), got {}{}",
                    in_quotes(name), nearest.empty() ? "" : "; did you mean " + in_quotes(nearest) + "?"));
}

}  // namespace kreisel
