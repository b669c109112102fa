// SPDX-License-Identifier: BSD-3-Clause
#include "driver/cli/catalogue/problems.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "driver/cli/catalogue/rows.hpp"
#include "driver/config/values.hpp"
#include "records/json/model.hpp"
#include "records/json/model_keys.hpp"
#include "records/json/writer.hpp"
#include "support/nearest.hpp"

namespace kreisel {

namespace {

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
    if (may_have_shape(type)) { text += fmt::format(", [{}]", shape_key); }
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
            if (may_have_shape(type)) { meanings.emplace_back(shape_key, shape_meaning); }
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

void print_parameters(std::ostream& out, const ProblemDescription& problem) {
    std::vector<NamedText> rows;
    for (const ParameterDescription& parameter : problem.parameters) {
        const std::string unit = parameter.unit.empty() ? "" : " [" + parameter.unit + "]";
        const std::string standard = parameter.required ? "required" : "default " + json_value(parameter.standard);
        rows.emplace_back(parameter.name,
                          fmt::format("{}{}: {} ({})", parameter.summary, unit, expectation(parameter.kind), standard));
    }
    print_rows(out, "Parameters", rows);
}

// Bodies, constraints and first integrals in each formulation.
void print_systems(std::ostream& out, const Engine& engine, const ProblemDescription& problem) {
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

}  // namespace

void describe_problem(const Engine& engine, const ProblemDescription& problem, std::ostream& out) {
    fmt::print(out, "{}: {}\n", problem.name, problem.summary);
    print_sources(out, problem.cites);
    fmt::print(out, "Closed form: {}\n", problem.closed_form ? "yes" : "none");
    print_parameters(out, problem);
    print_elements(out, problem);
    print_demonstration(out, problem);
    print_systems(out, engine, problem);
}

}  // namespace kreisel
