// SPDX-License-Identifier: BSD-3-Clause
#include "plots/figures/spec.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "plots/figures/kind.hpp"
#include "plots/figures/overlay/overlay_files.hpp"
#include "records/json/strict.hpp"
#include "records/kinds/kind.hpp"
#include "support/errors.hpp"

namespace kreisel {

namespace {

std::unique_ptr<Figure> new_figure(const FigureKind& kind, const std::string& experiment) {
    auto figure = kind.make();
    figure->kind = kind.name;
    figure->name = is_figure_name(experiment) ? experiment : "figure";
    return figure;
}

const FigureKind* read_figure_kind(const Node& node) {
    if (!node.require_object("an object that describes a figure, or a list of such objects")) { return nullptr; }
    std::vector<std::string> names;
    for (const FigureKind& kind : figure_kinds()) { names.push_back(kind.name); }
    const auto kind_node = node.require("kind", "a kind of figure");
    const auto name = kind_node ? kind_node->name("kind of figure", names) : std::nullopt;
    return name ? find_figure_kind(*name) : nullptr;
}

std::unique_ptr<Figure> read_figure(const Node& node, const std::string& experiment) {
    const FigureKind* kind = read_figure_kind(node);
    if (kind == nullptr) { return nullptr; }
    auto figure = new_figure(*kind, experiment);
    figure->pointer = node.pointer();
    std::vector<FigureKey> keys = common_figure_keys();
    keys.insert(keys.end(), kind->keys.begin(), kind->keys.end());
    std::vector<std::string> known = {"kind"};
    for (const FigureKey& key : keys) {
        known.push_back(key.name);
        if (const auto value = node.find(key.name)) { key.read(*value, *figure); }
    }
    node.only_keys(known);
    return figure;
}

// Those of a family, "invariant.", that some cell has and that are not 0 everywhere; without those that describe them
// further, such as "invariant.energy.final".
std::vector<std::string> measured_metrics(const Results& results, const std::string& family) {
    std::vector<std::string> names;
    for (const ResultRow& row : results.rows) {
        for (const auto& [name, value] : row.metrics) {
            const bool whole = name.starts_with(family) && name.find('.', family.size()) == std::string::npos;
            const bool known = std::find(names.begin(), names.end(), name) != names.end();
            if (whole && !known && value != 0) { names.push_back(name); }
        }
    }
    return names;
}

bool has_some(const Results& results, const std::vector<std::string>& metrics) {
    return std::any_of(results.rows.begin(), results.rows.end(), [&](const ResultRow& row) {
        return std::any_of(metrics.begin(), metrics.end(),
                           [&](const std::string& metric) { return row.metrics.contains(metric); });
    });
}

// One of another kind, a panel for each of its metrics that the cells have; null where they have none.
std::unique_ptr<Figure> figure_of_measured(const std::string& kind, const Results& results) {
    const std::vector<std::string> own = standard_figure(kind, results.name)->drawn_metrics();
    const std::string family = own.front().substr(0, own.front().find('.') + 1);
    auto metrics = measured_metrics(results, family);
    if (metrics.empty()) { return nullptr; }
    std::stable_partition(metrics.begin(), metrics.end(), [&](const std::string& one) { return one == own.front(); });
    const Document document = parse_document("figure", nlohmann::json{{"kind", kind}, {"metric", metrics}}.dump());
    Diagnostics diagnostics(document);
    auto figure = read_figure(Node(document.value, "", diagnostics), results.name);
    diagnostics.raise();
    return figure;
}

std::vector<std::unique_ptr<Figure>> figure_of_kind(const Results& results) {
    const ExperimentKind* known = find_experiment_kind(results.kind);
    if (known == nullptr) {
        throw FigureError(fmt::format("{}: no figure shows an experiment of kind {}; describe one under \"figure\"",
                                      results.name, results.kind));
    }
    std::vector<std::unique_ptr<Figure>> figures;
    figures.push_back(standard_figure(known->figure, results.name));
    const std::string otherwise = find_figure_kind(known->figure)->otherwise;
    if (!otherwise.empty() && !has_some(results, figures.front()->drawn_metrics())) {
        if (auto other = figure_of_measured(otherwise, results)) { figures.front() = std::move(other); }
    }
    return figures;
}

}  // namespace

std::unique_ptr<Figure> standard_figure(const std::string& kind, const std::string& experiment) {
    if (const FigureKind* known = find_figure_kind(kind)) { return new_figure(*known, experiment); }
    throw FigureError(fmt::format("{}: there is no figure of kind {}", experiment, kind));
}

std::vector<std::unique_ptr<Figure>> read_figures(const Node& figure, const std::string& experiment) {
    std::vector<std::unique_ptr<Figure>> figures;
    std::set<std::string> names;
    for (const Node& node : distinct(figure.elements_or_self(), "figure")) {
        auto one = read_figure(node, experiment);
        if (one == nullptr) { continue; }
        if (!names.insert(one->name).second) {
            node.violates(Rule::own_name, "figures with different names", fmt::format("\"{}\" twice", one->name));
        }
        figures.push_back(std::move(one));
    }
    return figures;
}

std::vector<std::unique_ptr<Figure>> figures_in_file(const std::filesystem::path& file, const std::string& experiment) {
    Document document = read_document(file);
    insert_overlay_files(document, "");
    Diagnostics diagnostics(document);
    auto figures = read_figures(Node(document.value, "", diagnostics), experiment);
    diagnostics.raise();
    return figures;
}

std::vector<std::unique_ptr<Figure>> figures_of(const Results& results) {
    if (results.config.empty()) { throw FileError("manifest.json: no config in it; figures need one"); }
    const Document document = parse_document("manifest.json (config)", results.config);
    if (!document.value.contains("figure")) { return figure_of_kind(results); }
    Diagnostics diagnostics(document);
    auto figures = read_figures(Node(document.value.at("figure"), "/figure", diagnostics), results.name);
    diagnostics.raise();
    return figures;
}

}  // namespace kreisel
