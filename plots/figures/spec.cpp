// SPDX-License-Identifier: BSD-3-Clause
#include "plots/figures/spec.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace kreisel {

namespace {

using Names = std::vector<std::string>;

const Names kinds = {"path3d", "motion", "components", "convergence", "drift", "invariants", "scaling"};
const Names axes = {"problem", "formulation", "method", "projection", "precision"};

// The keys that each kind understands, besides kind, name, title, select.
const Names& keys_of(const std::string& kind) {
    static const std::map<std::string, Names> keys = {
        {"path3d", {"body", "view", "until"}},
        {"motion", {"body", "view", "until", "instants", "radius", "lever"}},
        {"components", {"body", "until", "quantity", "stacked", "columns"}},
        {"convergence", {"metric", "facet", "columns"}},
        {"drift", {"metric", "facet", "columns"}},
        {"scaling", {"metric", "facet", "columns"}},
        {"invariants", {"metric", "facet", "columns", "relative"}}};
    return keys.at(kind);
}

template <std::size_t n>
std::optional<std::array<double, n>> read_numbers(const Node& node, const std::string& expected) {
    if (!node.is_array() || node.json().size() != n) {
        node.mismatch(expected);
        return std::nullopt;
    }
    std::array<double, n> result{};
    const auto entries = node.elements(expected);
    for (std::size_t i = 0; entries && i < n; ++i) {
        const auto value = (*entries)[i].number();
        if (!value) { return std::nullopt; }
        result[i] = *value;
    }
    return result;
}

void read_select(const Node& node, FigureSpec& spec) {
    if (!node.require_object("an object such as {\"formulation\": \"SE3\"}")) { return; }
    Names known = axes;
    known.push_back("steps");
    node.only_keys(known);
    for (const std::string& key : known) {
        const auto value = node.find(key);
        if (!value) { continue; }
        for (const Node& entry : value->elements_or_self()) {
            if (key == "steps") {
                if (const auto steps = entry.count(1, largest_count, "steps")) {
                    spec.select[key].push_back(fmt::format("{}", *steps));
                }
            } else if (const auto text = entry.text("a name, or a list of names")) {
                spec.select[key].push_back(*text);
            }
        }
    }
}

void read_name(const Node& node, FigureSpec& spec) {
    const std::string expected = "a file name without extension: up to 80 of a-z, 0-9, \"_\", \"-\"";
    const auto name = node.text(expected);
    if (!name) { return; }
    if (!is_figure_name(*name)) { return node.mismatch(expected); }
    spec.name = *name;
}

void read_metrics(const Node& node, FigureSpec& spec) {
    static const std::map<std::string, std::string> families = {
        {"convergence", "error."}, {"drift", "defect."}, {"invariants", "invariant."}, {"scaling", "cost."}};
    const std::string& family = families.at(spec.kind);
    const std::string expected =
        fmt::format("{} metric {}*, or a list of them", family == "defect." || family == "cost." ? "a" : "an", family);
    spec.metrics.clear();
    for (const Node& entry : node.elements_or_self()) {
        const auto metric = entry.text(expected, 100);
        if (!metric) { continue; }
        const bool plain = metric->starts_with(family) && metric->size() > family.size() &&
                           metric->find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_.") == std::string::npos;
        if (!plain) {
            entry.mismatch(expected);
        } else {
            spec.metrics.push_back(*metric);
        }
    }
}

void read_drawing(const Node& node, FigureSpec& spec) {
    if (const auto body = node.find("body")) { spec.body = body->text("the name of a body").value_or(""); }
    if (const auto view = node.find("view")) {
        spec.view = read_numbers<2>(*view, "two angles in degrees, [elevation, azimuth]").value_or(spec.view);
    }
    if (const auto until = node.find("until")) { spec.until = until->positive("a time greater than 0, s"); }
    if (const auto lever = node.find("lever")) { spec.lever = read_numbers<3>(*lever, "three numbers"); }
    if (const auto radius = node.find("radius")) { spec.radius = radius->positive().value_or(spec.radius); }
    if (const auto instants = node.find("instants")) {
        spec.instants = instants->count(1, 100, "instants").value_or(spec.instants);
    }
    if (const auto quantity = node.find("quantity")) {
        spec.quantity = quantity->name("quantity", {"x", "v", "omega", "multipliers"}).value_or(spec.quantity);
    }
    if (const auto stacked = node.find("stacked")) { spec.stacked = stacked->flag().value_or(false); }
    if (const auto relative = node.find("relative")) { spec.relative = relative->flag().value_or(false); }
}

FigureSpec read_figure(const Node& node, const std::string& experiment) {
    FigureSpec spec;
    if (!node.require_object("an object that describes a figure, or a list of such objects")) { return spec; }
    const auto kind_node = node.require("kind", "a kind of figure");
    const auto kind = kind_node ? kind_node->name("kind of figure", kinds) : std::nullopt;
    if (!kind) { return spec; }
    spec = standard_figure(*kind, experiment);
    spec.pointer = node.pointer();
    Names known = {"kind", "name", "title", "select"};
    known.insert(known.end(), keys_of(*kind).begin(), keys_of(*kind).end());
    node.only_keys(known);
    if (const auto name = node.find("name")) { read_name(*name, spec); }
    if (const auto title = node.find("title")) { spec.title = title->text("a title").value_or(""); }
    if (const auto select = node.find("select")) { read_select(*select, spec); }
    if (const auto facet = node.find("facet")) { spec.facet = facet->name("facet", axes).value_or(""); }
    if (const auto metric = node.find("metric")) { read_metrics(*metric, spec); }
    if (const auto columns = node.find("columns")) {
        spec.columns = columns->count(1, 4, "panels beside each other").value_or(spec.columns);
    }
    read_drawing(node, spec);
    return spec;
}

}  // namespace

bool is_figure_name(const std::string& name) {
    const bool letters = name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_-") == std::string::npos;
    return letters && !name.empty() && name.size() <= 80 && name[0] != '-';
}

bool draws_samples(const std::string& kind) { return kind != "convergence" && kind != "scaling"; }

FigureSpec standard_figure(const std::string& kind, const std::string& experiment) {
    FigureSpec spec;
    spec.kind = kind == "trajectory" ? "components" : kind;
    spec.name = is_figure_name(experiment) ? experiment : "figure";
    if (spec.kind == "convergence") { spec.metrics = {"error.position"}; }
    if (spec.kind == "drift") { spec.metrics = {"defect.position", "defect.velocity"}; }
    if (spec.kind == "scaling") { spec.metrics = {"cost.step", "cost.memory"}; }
    if (spec.kind == "invariants") { spec.metrics = {"invariant.energy"}; }
    return spec;
}

std::vector<FigureSpec> read_figures(const Node& figure, const std::string& experiment) {
    std::vector<FigureSpec> specs;
    std::set<std::string> names;
    for (const Node& node : figure.elements_or_self()) {
        specs.push_back(read_figure(node, experiment));
        if (!names.insert(specs.back().name).second && !specs.back().name.empty()) {
            node.error("figures with different names", fmt::format("\"{}\" twice", specs.back().name));
        }
    }
    return specs;
}

}  // namespace kreisel
