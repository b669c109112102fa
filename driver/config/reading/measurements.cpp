// SPDX-License-Identifier: BSD-3-Clause
#include "driver/config/reading/measurements.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "plots/figures/spec.hpp"
#include "records/kinds/kind.hpp"

namespace kreisel {

namespace {

void read_output(const Node& root, Config& config) {
    const auto output = root.find("output");
    if (!output || !output->require_object("an object with \"samples\"")) { return; }
    output->only_keys({"samples", "dense"});
    if (const auto dense = output->find("dense")) { config.dense = dense->flag().value_or(true); }
    const auto node = output->find("samples");
    const auto samples = node ? node->count(0, most_samples, "a number of samples") : std::nullopt;
    config.samples = samples.value_or(0);
    for (const long steps : config.steps) {
        if (config.samples > 0 && steps % config.samples != 0) {
            node->error(
                "a number that divides every number of steps, since samples of constant steps are not interpolated",
                fmt::format("{}, which does not divide {}", config.samples, steps));
            return;
        }
    }
}

void read_metrics(const Node& root, Config& config) {
    const ExperimentKind* kind = find_experiment_kind(config.kind);
    config.metrics = kind == nullptr ? std::vector<std::string>() : kind->metrics;
    const auto node = root.find("metrics");
    if (!node) { return; }
    config.metrics_given = true;
    config.metrics.clear();
    if (!node->is_array()) {
        node->mismatch("a list of metrics or patterns such as \"error.*\" (an empty list measures nothing)");
        return;
    }
    for (const Node& entry : node->elements_or_self()) {
        const auto pattern = entry.text("a metric or a pattern such as \"error.*\"", 100);
        if (pattern && std::find(config.metrics.begin(), config.metrics.end(), *pattern) != config.metrics.end()) {
            entry.error("each metric once", in_quotes(*pattern) + " again");
        } else if (pattern) {
            config.metrics.push_back(*pattern);
        }
    }
}

// Other measurements on the way would be timed with the steps.
void check_timed(const Node& root, const Config& config) {
    if (!config.is_timed()) { return; }
    if (!config.metrics.empty()) {
        root.find("metrics")->error("no metrics (an empty list, or none): this kind measures only the steps",
                                    listed(config.metrics));
    }
    if (config.samples > 0) {
        root.find("output")->find("samples")->error("0: this kind measures only the steps",
                                                    fmt::format("{}", config.samples));
    }
    if (!config.tolerances.empty()) {
        root.find("time")->find("tolerance")->error("steps of one size: this kind measures a step", "a tolerance");
    }
}

void read_figure(const Node& root, Config& config) {
    const auto node = root.find("figure");
    if (!node) { return; }
    read_figures(*node, config.name);
    config.figure = node->json().dump();
}

}  // namespace

void read_measurements(const Node& root, Config& config) {
    read_output(root, config);
    read_metrics(root, config);
    read_figure(root, config);
    check_timed(root, config);
}

}  // namespace kreisel
