// SPDX-License-Identifier: BSD-3-Clause
#include "driver/cli/catalogue/metrics.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <map>
#include <set>

#include "driver/plan/metric_names.hpp"
#include "records/metrics/catalogue.hpp"

namespace kreisel {

namespace {

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

// The family of a name such as invariant.energy.slope, and the problems that have it.
bool describe_invariant(const Engine& engine, const std::string& name, std::ostream& out) {
    for (const IntegralSuffix& suffix : integral_suffixes) {
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

}  // namespace

std::vector<NamedText> metric_rows() {
    std::vector<NamedText> rows;
    for (const MetricDescription& metric : metric_catalogue()) {
        rows.emplace_back(metric.name, fmt::format("{} [{}]", metric.summary, metric.unit));
    }
    rows.emplace_back("error.<name>.max", "the largest error over the samples");
    rows.emplace_back("defect.<name>.final", "the defect at the end");
    rows.emplace_back(
        "structure.<name>.uncertainty",
        "what differences and round-off leave; what is below ten times that counts as zero, and is absent");
    for (const IntegralSuffix& suffix : integral_suffixes) {
        rows.emplace_back(std::string("invariant.<integral>") + suffix.name,
                          fmt::format("{} [{}]", suffix.summary, suffix.unit));
    }
    return rows;
}

std::vector<std::string> integral_names(const Engine& engine) {
    std::set<std::string> names;
    for (const auto& [problem, integrals] : integrals_by_problem(engine)) {
        for (const IntegralDescription& integral : integrals) { names.insert(integral.name); }
    }
    return {names.begin(), names.end()};
}

bool describe_metric(const Engine& engine, const std::string& name, std::ostream& out) {
    const MetricDescription* metric = find_metric(name);
    if (metric == nullptr) { return describe_invariant(engine, name, out); }
    const auto names = names_of_metric(*metric);
    if (std::find(names.begin(), names.end(), name) == names.end()) { return false; }
    const char* part = name == metric->name    ? ""
                       : is_error(*metric)     ? "the largest over the samples: "
                       : is_structure(*metric) ? "to how much this is certain: "
                                               : "the same at the end: ";
    fmt::print(out, "{}: {}{} [{}]\n", name, part, metric->summary, metric->unit);
    return true;
}

}  // namespace kreisel
