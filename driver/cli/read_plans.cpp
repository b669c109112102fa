// SPDX-License-Identifier: BSD-3-Clause
#include "driver/cli/read_plans.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>

#include "driver/config/composition/composed.hpp"
#include "driver/config/composition/filter.hpp"
#include "driver/config/shipped.hpp"
#include "driver/plan/metric_names.hpp"
#include "records/json/diagnostics.hpp"
#include "records/reference_store.hpp"

namespace kreisel {

namespace {

void print_warnings(const Plan& plan, const std::string& file, std::ostream& messages) {
    for (const std::string& warning : plan.warnings) { fmt::print(messages, "{}: warning: {}\n", file, warning); }
}

// Where a config asks for errors, and how: by a metric, or by its kind.
Issue asks_where(const Config& config) {
    if (!config.metrics_given) { return {.pointer = "/kind", .got = fmt::format("the metrics of {}", config.kind)}; }
    std::size_t i = 0;
    while (!asks_for_errors({config.metrics.at(i)}) && !asks_for_largest_errors({config.metrics[i]})) { ++i; }
    return {.pointer = fmt::format("/metrics/{}", i), .got = in_quotes(config.metrics[i])};
}

// What computes no references must have been given all.
void require_references(const Document& document, const Plan& plan, const std::filesystem::path& given,
                        const Engines& engines) {
    const auto is_missing = [&](const auto& entry) {
        return !given_reference(given, entry.second, engines.reference_digest());
    };
    const auto missing = std::find_if(plan.references.begin(), plan.references.end(), is_missing);
    if (engines.has_quad() || missing == plan.references.end()) { return; }
    const PlannedReference& wanted = missing->second;
    Issue issue = asks_where(plan.config);
    issue.expected = fmt::format(
        "metrics without error.*, or --references DIR with results of a kreisel of the same sources that has quad "
        "precision, which this program lacks (KREISEL_BINARY128=OFF), and in them a reference of {} at t = {} s{}",
        wanted.problem, wanted.t_end, wanted.samples > 0 ? fmt::format(" with {} samples", wanted.samples) : "");
    issue.rule = Rule::quad;
    Diagnostics sink(document);
    sink.add(std::move(issue));
    sink.raise();
}

// What is damaged there is computed again, or counts as missing.
void say_of_given(const std::filesystem::path& given, std::ostream& messages) {
    if (given.empty()) { return; }
    for (const std::string& text : reference_damage(given)) { fmt::print(messages, "{}\n", text); }
}

}  // namespace

Paths config_files(const Paths& written) {
    Paths files;
    std::string errors;
    for (const auto& one : written) {
        try {
            files.push_back(config_file(one));
        } catch (const UsageError& error) { errors += (errors.empty() ? "" : "\n") + std::string(error.what()); }
    }
    if (!errors.empty()) { throw UsageError(errors); }
    return files;
}

std::vector<Plan> read_plans(const Paths& files, const ConfigChanges& changes, const std::filesystem::path& references,
                             const Engines& engines, std::ostream& messages) {
    say_of_given(references, messages);
    const Catalogue catalogue(engines.binary64);
    std::vector<Plan> plans;
    std::string errors;
    for (const auto& file : files) {
        try {
            const Document document = composed_config(file, changes.settings);
            Config config = read_config(document, catalogue);
            apply_filters(changes.filters, config);
            plans.push_back(make_plan(document, config, engines));
            require_references(document, plans.back(), references, engines);
            print_warnings(plans.back(), file.string(), messages);
        } catch (const UsageError& error) { errors += (errors.empty() ? "" : "\n") + std::string(error.what()); }
    }
    if (!errors.empty()) { throw UsageError(errors); }
    return plans;
}

}  // namespace kreisel
