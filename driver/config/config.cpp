// SPDX-License-Identifier: BSD-3-Clause
#include "driver/config/config.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>

#include "driver/config/options.hpp"
#include "driver/config/parameters.hpp"
#include "driver/config/time.hpp"
#include "plots/figures/spec.hpp"
#include "records/json/node.hpp"
#include "records/json/writer.hpp"
#include "support/nearest.hpp"

namespace kreisel {

namespace {

constexpr long most_samples = 10'000'000;

// A file name on every system: no separator, no leading dot or dash.
bool is_plain_name(const std::string& name) {
    const auto plain = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-' ||
               c == '.';
    };
    return std::all_of(name.begin(), name.end(), plain) && name.front() != '.' && name.front() != '-';
}

void read_name(const Node& root, Config& config) {
    const std::string expected = "a name of letters, digits, '_', '-' and '.', beginning with neither '.' nor '-'";
    const auto node = root.require("name", expected);
    const auto name = node ? node->text(expected, 100) : std::nullopt;
    if (name && !is_plain_name(*name)) { node->mismatch(expected); }
    config.name = name.value_or("");
}

void read_kind(const Node& root, Config& config) {
    const std::vector<std::string>& kinds = runnable_kinds();
    const auto node = root.require("kind", "one of " + listed(kinds));
    if (!node) { return; }
    config.kind = node->name("a kind", kinds).value_or("");
}

std::vector<std::string> read_names(const Node& root, const std::string& key, const std::string& what,
                                    const std::vector<std::string>& names, const std::vector<std::string>& standard) {
    const auto node = root.find(key);
    if (!node) { return standard; }
    std::vector<std::string> result;
    const auto entries = node->elements("a list of at least one " + what);
    for (const Node& entry : entries.value_or(std::vector<Node>())) {
        const auto name = entry.name("a " + what, names);
        if (name && std::find(result.begin(), result.end(), *name) != result.end()) {
            entry.error("each " + what + " once", in_quotes(*name) + " again");
        } else if (name) {
            result.push_back(*name);
        }
    }
    return result;
}

// Only "precision" may also be a bare string.
std::vector<std::string> read_precisions(const Node& root) {
    const std::vector<std::string> names = {"double", "quad"};
    const auto node = root.find("precision");
    if (node && node->is_array()) { return read_names(root, "precision", "precision", names, {}); }
    if (!node) { return {"double"}; }
    const auto name = node->name("a precision or a list of them", names);
    return name ? std::vector<std::string>{*name} : std::vector<std::string>();
}

// The name of an entry that is a string or an object with "name", and its description.
template <class Description>
const Description* described(const Node& entry, const std::string& what, const std::vector<Description>& known) {
    const auto names = names_of(known);
    if (!entry.is_object()) {
        if (!entry.is_string()) {
            entry.mismatch(fmt::format("a {}: a name, or an object with \"name\" and options", what));
            return nullptr;
        }
        const auto name = entry.name("a " + what, names);
        return name ? find_named(known, *name) : nullptr;
    }
    const auto node = entry.require("name", "a " + what);
    const auto name = node ? node->name("a " + what, names) : std::nullopt;
    return name ? find_named(known, *name) : nullptr;
}

std::string read_label(const Node& entry, const std::string& standard) {
    const auto node = entry.is_object() ? entry.find("label") : std::nullopt;
    const auto label = node ? node->text("a label") : std::nullopt;
    // Spreadsheets read a cell with such a first character as a formula.
    if (label && std::string_view("=+-@").find(label->front()) != std::string_view::npos) {
        node->mismatch("a label that does not begin with '=', '+', '-' or '@'");
    }
    return label.value_or(standard);
}

void add_problem(const Node& entry, ProblemEntry problem, Config& config) {
    for (const ProblemEntry& other : config.problems) {
        if (other.label == problem.label) {
            entry.error("a \"label\" of its own for each problem",
                        in_quotes(problem.label) + " again, as at " + other.pointer);
            return;
        }
        if (other.name == problem.name && other.parameters == problem.parameters) {
            entry.error("each problem once", "the same problem as at " + other.pointer);
            return;
        }
    }
    config.problems.push_back(std::move(problem));
}

void add_problems(const Node& entry, const ProblemDescription& description, Config& config) {
    const std::string series = read_label(entry, description.name);
    std::vector<ParameterPoint> points = {{default_parameters(description), ""}};
    if (entry.is_object()) { entry.only_keys({"name", "label", "parameters"}); }
    const auto parameters = entry.is_object() ? entry.find("parameters") : std::nullopt;
    const std::vector<std::string> required = required_parameters(description);
    if (parameters) {
        points = read_parameters(*parameters, description);
    } else if (!required.empty()) {
        entry.error(fmt::format("the parameters of {}, at least {} (see kreisel info {})", in_quotes(description.name),
                                listed(required), description.name),
                    "none");
        return;
    }
    for (ParameterPoint& point : points) {
        add_problem(entry, {description.name, series, series + point.listed, std::move(point.values), entry.pointer()},
                    config);
    }
}

void read_problems(const Node& root, const Registry& registry, Config& config) {
    const auto node = root.require("problems", "a list of at least one problem");
    const auto entries = node ? node->elements("a list of at least one problem") : std::nullopt;
    for (const Node& entry : entries.value_or(std::vector<Node>())) {
        if (const auto* description = described(entry, "problem", registry.problems)) {
            add_problems(entry, *description, config);
        }
    }
}

// The descriptions that an entry of the list names: one, or several by "*" and "family/*".
template <class Description>
std::vector<const Description*> described_by(const Node& entry, const std::string& what,
                                             const std::vector<Description>& known) {
    std::vector<const Description*> all;
    const std::string text = entry.is_string() ? entry.json().get<std::string>() : "";
    const auto wildcards = wildcards_of(known);
    if (std::find(wildcards.begin(), wildcards.end(), text) == wildcards.end()) {
        if (const Description* one = described(entry, what, known)) { all.push_back(one); }
        return all;
    }
    for (const Description& one : known) {
        if (one.name.starts_with(text.substr(0, text.size() - 1))) { all.push_back(&one); }
    }
    return all;
}

template <class Description>
void add_optioned(const Node& entry, const std::string& what, const Description& description,
                  std::vector<OptionedEntry>& result) {
    const auto combinations =
        entry.is_object() ? read_options(entry, description.options) : default_options(description.options);
    for (const OptionValues& options : combinations) {
        const auto twin = std::find_if(result.begin(), result.end(), [&](const OptionedEntry& other) {
            return other.name == description.name && other.options == options;
        });
        if (twin != result.end()) {
            entry.error("each " + what + " once", "the same as at " + twin->pointer);
        } else {
            result.push_back({description.name, options, entry.pointer()});
        }
    }
}

template <class Description>
std::vector<OptionedEntry> read_optioned(const Node& list, const std::string& what,
                                         const std::vector<Description>& known) {
    std::vector<OptionedEntry> result;
    const auto entries = list.elements("a list of at least one " + what);
    for (const Node& entry : entries.value_or(std::vector<Node>())) {
        for (const Description* description : described_by(entry, what, known)) {
            add_optioned(entry, what, *description, result);
        }
    }
    return result;
}

void read_methods(const Node& root, const Registry& registry, Config& config) {
    if (const auto node = root.require("methods", "a list of at least one method")) {
        config.methods = read_optioned(*node, "method", registry.methods);
    }
    if (const auto node = root.find("projections")) {
        config.projections = read_optioned(*node, "projection", registry.projections);
    } else if (const auto* none = find_named(registry.projections, "none")) {
        config.projections = {{none->name, default_options(none->options).front(), ""}};
    }
}

void read_output(const Node& root, Config& config) {
    const auto output = root.find("output");
    if (!output || !output->require_object("an object with \"samples\"")) { return; }
    output->only_keys({"samples"});
    const auto node = output->find("samples");
    const auto samples = node ? node->count(0, most_samples, "a number of samples") : std::nullopt;
    config.samples = samples.value_or(0);
    for (const long steps : config.steps) {
        if (config.samples > 0 && steps % config.samples != 0) {
            node->error("a number that divides every number of steps, since samples are not interpolated",
                        fmt::format("{}, which does not divide {}", config.samples, steps));
            return;
        }
    }
}

std::vector<std::string> standard_metrics(const std::string& kind) {
    if (kind == "scaling") { return {}; }
    if (kind == "convergence") { return {"error.*", "defect.*", "invariant.*"}; }
    return {"defect.*", "invariant.*"};
}

void read_metrics(const Node& root, Config& config) {
    config.metrics = standard_metrics(config.kind);
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
}

void read_figure(const Node& root, Config& config) {
    const auto node = root.find("figure");
    if (!node) { return; }
    read_figures(*node, config.name);
    config.figure = node->json();
}

void read_description(const Node& root, Config& config) {
    if (const auto node = root.find("description")) {
        config.description = node->text("a text that describes the experiment", 2000).value_or("");
    }
}

}  // namespace

const std::vector<std::string>& runnable_kinds() {
    static const std::vector<std::string> kinds = {"trajectory", "convergence", "drift", "scaling"};
    return kinds;
}

const std::vector<std::string>& config_keys() {
    static const std::vector<std::string> keys = {"name",     "description",  "kind",    "precision",
                                                  "problems", "formulations", "methods", "projections",
                                                  "time",     "metrics",      "output",  "figure"};
    return keys;
}

Config read_config(const Document& document, const Registry& registry) {
    Diagnostics sink(document);
    const Node root(document.value, "", sink);
    Config config;
    if (!root.require_object("a config: an object with the keys " + listed(config_keys()))) { sink.raise(); }
    root.only_keys(config_keys());
    read_name(root, config);
    read_description(root, config);
    read_kind(root, config);
    config.precisions = read_precisions(root);
    read_problems(root, registry, config);
    config.formulations = read_names(root, "formulations", "formulation", names_of(registry.formulations), {"SO3xR3"});
    read_methods(root, registry, config);
    if (const auto time = root.require("time", "an object with \"end\" and \"steps\" or \"step\"")) {
        read_time(*time, config);
    }
    read_output(root, config);
    read_metrics(root, config);
    read_figure(root, config);
    check_timed(root, config);
    sink.raise();
    return config;
}

}  // namespace kreisel
