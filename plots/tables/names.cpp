// SPDX-License-Identifier: BSD-3-Clause
#include "plots/tables/names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace kreisel {

namespace {

using Options = std::map<std::string, std::string>;

std::vector<std::string> varying(const std::vector<const Options*>& all) {
    std::map<std::string, std::set<std::string>> values;
    for (const Options* options : all) {
        for (const auto& [name, value] : *options) { values[name].insert(value); }
    }
    std::vector<std::string> names;
    for (const auto& [name, set] : values) {
        if (set.size() > 1) { names.push_back(name); }
    }
    return names;
}

// The two coordinate maps are clear from their names; other options are shown with their key.
std::string option_text(const std::string& name, const std::string& value) {
    return name == "coordinates" ? value : fmt::format("{}={}", name, value);
}

// Empty if the options have none.
std::string label_of(const Options& options) {
    const auto label = options.find("label");
    return label == options.end() ? "" : label->second;
}

// The options that do not vary among any rows of one label.
std::set<std::string> labelled(const std::vector<const Options*>& all) {
    std::map<std::string, std::vector<const Options*>> by_label;
    std::set<std::string> names;
    for (const Options* options : all) {
        by_label[label_of(*options)].push_back(options);
        for (const auto& [name, value] : *options) { names.insert(name); }
    }
    by_label.erase("");
    for (const auto& [label, rows] : by_label) {
        for (const std::string& name : varying(rows)) { names.erase(name); }
    }
    return names;
}

std::string with_options(const std::string& name, const Options& options, const std::vector<std::string>& shown,
                         const std::set<std::string>& labelled = {}) {
    const std::string label = label_of(options);
    std::string text = name + (label.empty() ? "" : " " + label);
    for (const std::string& option : shown) {
        if (option == "label" || (!label.empty() && labelled.contains(option))) { continue; }
        const auto value = options.find(option);
        if (value != options.end()) { text += " " + option_text(option, value->second); }
    }
    return text;
}

}  // namespace

std::vector<std::string> option_texts(const std::map<std::string, std::string>& options) {
    std::vector<std::string> texts;
    if (const std::string label = label_of(options); !label.empty()) { texts.push_back(label); }
    for (const auto& [name, value] : options) {
        if (name != "label") { texts.push_back(option_text(name, value)); }
    }
    return texts;
}

CellNames::CellNames(const std::vector<ResultRow>& rows) : rows_(rows) {
    std::map<std::string, std::vector<const Options*>> by_name;
    for (const ResultRow& row : rows) {
        by_name[row.method].push_back(&*row.options);
        by_name["projection " + row.projection].push_back(&*row.projection_options);
        (row.adaptive() ? adaptive_ : constant_).insert(row.method);
    }
    for (const auto& [name, options] : by_name) {
        varying_options_[name] = varying(options);
        labelled_options_[name] = labelled(options);
    }
}

const std::vector<std::string>& CellNames::axes() {
    static const std::vector<std::string> all = {"problem", "formulation", "method", "projection", "precision"};
    return all;
}

const std::vector<std::string>& CellNames::figure_axes() {
    static const std::vector<std::string> all = [] {
        std::vector<std::string> names = axes();
        names.insert(names.begin(), "results");
        return names;
    }();
    return all;
}

std::string CellNames::axis(const ResultRow& row, const std::string& axis) const {
    if (axis == "results") { return row.results; }
    if (axis == "problem") { return row.label; }
    if (axis == "formulation") { return row.formulation; }
    if (axis == "method") {
        const bool both = adaptive_.contains(row.method) && constant_.contains(row.method);
        return with_options(row.method, row.options, varying_options_.at(row.method),
                            labelled_options_.at(row.method)) +
               (both && row.adaptive() ? " adaptive" : "");
    }
    if (axis == "projection") {
        return with_options(row.projection, row.projection_options,
                            varying_options_.at("projection " + row.projection));
    }
    return row.precision;
}

std::vector<std::string> CellNames::varying_axes(const std::vector<std::string>& left_out) const {
    std::vector<std::string> result;
    for (const std::string& name : figure_axes()) {
        if (std::find(left_out.begin(), left_out.end(), name) != left_out.end()) { continue; }
        std::set<std::string> values;
        for (const ResultRow& row : rows_) { values.insert(axis(row, name)); }
        if (values.size() > 1) { result.push_back(name); }
    }
    return result;
}

std::string CellNames::legend(const ResultRow& row, const std::vector<std::string>& axes) const {
    std::string text;
    for (const std::string& name : axes) {
        const bool bare = name == "projection" && row.projection == "none";
        text += (text.empty() ? "" : ", ") + (bare ? std::string("no projection") : axis(row, name));
    }
    return text.empty() ? axis(row, "method") : text;
}

std::vector<CellGroup> grouped(const std::vector<ResultRow>& rows, bool (*same)(const ResultRow&, const ResultRow&)) {
    std::vector<CellGroup> groups;
    for (const ResultRow& row : rows) {
        const auto group = std::find_if(groups.begin(), groups.end(),
                                        [&](const CellGroup& other) { return same(other.front(), row); });
        if (group == groups.end()) {
            groups.push_back({{&row}});
        } else {
            group->rows.push_back(&row);
        }
    }
    return groups;
}

bool same_but_for_size(const ResultRow& a, const ResultRow& b) {
    return a.results == b.results && a.problem == b.problem && a.label == b.label && a.formulation == b.formulation &&
           a.method == b.method && a.options == b.options && a.projection == b.projection &&
           a.projection_options == b.projection_options && a.precision == b.precision && a.adaptive() == b.adaptive() &&
           a.controller == b.controller;
}

std::vector<CellGroup> group_by_method(const std::vector<ResultRow>& rows) {
    return grouped(rows, [](const ResultRow& a, const ResultRow& b) {
        return same_but_for_size(a, b) && a.parameters == b.parameters && a.t_end == b.t_end;
    });
}

}  // namespace kreisel
