// SPDX-License-Identifier: BSD-3-Clause
#include "driver/config/reading/measurements.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "driver/config/keys/keys.hpp"
#include "driver/config/reading/figure_demands.hpp"
#include "plots/figures/spec.hpp"
#include "records/kinds/kind.hpp"
#include "records/metrics/catalogue.hpp"
#include "support/nearest.hpp"

namespace kreisel {

namespace {

void read_output(const Node& root, Config& config) {
    const auto output = find_key(root, config_keys(), "output");
    if (!output || !output->require_object("an object with \"samples\"")) { return; }
    output->only_keys(names_of(output_keys()));
    config.dense = read_key(*output, output_keys(), "dense", FlagKind()).value_or(true);
    config.samples = read_key(*output, output_keys(), "samples", sample_count_kind()).value_or(0);
    for (const long steps : config.steps) {
        if (config.samples > 0 && steps % config.samples != 0) {
            output->find("samples")->violates(
                Rule::whole_strides,
                "a number that divides every number of steps, since samples of constant steps are not interpolated",
                fmt::format("{}, which does not divide {}", config.samples, steps));
            return;
        }
    }
}

// A name of the engine, of a first integral, which problems have, or a pattern.
std::optional<std::string> read_metric(const Node& entry) {
    const std::string expected = "a metric (see kreisel list metrics), or a pattern such as \"error.*\"";
    auto metric = entry.text(expected, 100);
    if (!metric || metric->find('*') != std::string::npos || metric->starts_with("invariant.")) { return metric; }
    const auto& names = names_of_metrics();
    if (std::find(names.begin(), names.end(), *metric) != names.end()) { return metric; }
    entry.mismatch(expected, nearest_name(*metric, names));
    return std::nullopt;
}

void read_metrics(const Node& root, Config& config) {
    const ExperimentKind* kind = find_experiment_kind(config.kind);
    config.metrics = kind == nullptr ? std::vector<std::string>() : kind->metrics;
    const auto node = find_key(root, config_keys(), "metrics");
    if (!node) { return; }
    config.metrics_given = true;
    config.metrics.clear();
    if (!node->is_array()) {
        node->mismatch("a list of metrics or patterns such as \"error.*\" (an empty list measures nothing)");
        return;
    }
    for (const Node& entry : distinct(node->elements_or_self(), "metric")) {
        if (const auto metric = read_metric(entry)) { config.metrics.push_back(*metric); }
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

// Whether the experiment is of a kind, and has steps and samples, that a figure can draw.
void check_demands(const Node& root, const Figure& figure) {
    const nlohmann::json& shown = root.json().at(nlohmann::json::json_pointer(figure.pointer));
    for (const FigureDemand& demand : figure_demands()) {
        if (!demand.concerns(figure.kind, figure.drawn_against()) || provides(root.json(), demand.needs)) { continue; }
        const Node at(shown.at(demand.key()), pointer_below(figure.pointer, demand.key()), root.sink());
        at.mismatch(demand.expected);
        return;
    }
}

// That what a figure selects is a name that there is; of what has options it is not known before the run.
void check_selected(const Node& root, const Figure& figure, const std::string& axis,
                    const std::vector<std::string>& names) {
    if (!figure.select.contains(axis)) { return; }
    const std::string pointer = figure.pointer + "/select/" + axis;
    const Node selected(root.json().at(nlohmann::json::json_pointer(pointer)), pointer, root.sink());
    for (const Node& entry : selected.elements_or_self()) {
        const bool with_options =
            entry.is_string() && entry.json().get_ref<const std::string&>().find(' ') != std::string::npos;
        if (axis == "formulation" || !with_options) { entry.name("a " + axis, names); }
    }
}

void read_figure(const Node& root, const Catalogue& catalogue, Config& config) {
    const auto node = find_key(root, config_keys(), "figure");
    if (!node) { return; }
    for (const auto& figure : read_figures(*node, config.name)) {
        check_demands(root, *figure);
        check_selected(root, *figure, "formulation", names_of(catalogue.formulations));
        check_selected(root, *figure, "projection", names_of(catalogue.projections));
    }
    config.figure = node->json().dump();
}

}  // namespace

void read_measurements(const Node& root, const Catalogue& catalogue, Config& config) {
    read_output(root, config);
    read_metrics(root, config);
    read_figure(root, catalogue, config);
    check_timed(root, config);
}

}  // namespace kreisel
