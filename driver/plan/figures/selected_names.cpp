// SPDX-License-Identifier: BSD-3-Clause
#include "driver/plan/figures/selected_names.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "plots/figures/cells/cell_value.hpp"
#include "support/nearest.hpp"

namespace kreisel {

namespace {

std::vector<std::string> entry_names(const std::vector<OptionedEntry>& entries) {
    std::vector<std::string> names;
    names.reserve(entries.size());
    for (const OptionedEntry& entry : entries) { names.push_back(entry.name); }
    return names;
}

}  // namespace

std::vector<std::string> selectable(const std::string& key, const Config& config) {
    std::vector<std::string> values;
    if (key == "steps") {
        for (const long steps : config.steps) { values.push_back(fmt::format("{}", steps)); }
    }
    if (key == "results") { values = {config.name}; }
    if (key == "problem") {
        for (const ProblemPoint& problem : config.problems) {
            values.insert(values.end(), {problem.label(), problem.series_label(), problem.name()});
        }
    }
    if (key == "tolerance") {
        for (const double tolerance : config.tolerances) { values.push_back(fmt::format("{}", tolerance)); }
    }
    if (key == "formulation") { values = config.formulations; }
    if (key == "precision") { values = config.precisions; }
    if (key == "method") { values = entry_names(config.methods); }
    if (key == "projection") { values = entry_names(config.projections); }
    return values;
}

bool has_options(const std::string& key, const std::string& value) {
    return (key == "method" || key == "projection") && value.find(' ') != std::string::npos;
}

std::string place_of_entry(const Document& document, const std::string& pointer, std::size_t i) {
    const nlohmann::json::json_pointer path(pointer);
    if (!document.value.contains(path)) { return pointer.substr(0, pointer.rfind('/')); }
    return document.value.at(path).is_array() ? fmt::format("{}/{}", pointer, i) : pointer;
}

void check_selected_names(const Document& document, const Config& config, const Figure& figure, Diagnostics& sink) {
    for (const auto& [key, values] : figure.select) {
        if (is_cell_value(key)) { continue; }
        const auto known = selectable(key, config);
        for (std::size_t i = 0; i < values.size(); ++i) {
            const std::string& value = values[i];
            if (has_options(key, value) || std::find(known.begin(), known.end(), value) != known.end()) { continue; }
            sink.add({.pointer = place_of_entry(document, fmt::format("{}/select/{}", figure.pointer, key), i),
                      .expected = key == "steps" ? fmt::format("one of the numbers of steps of this experiment ({})",
                                                               fmt::join(known, ", "))
                                                 : fmt::format("a {} of this experiment", key),
                      .got = key == "steps" || key == "tolerance" ? value : in_quotes(value),
                      .suggestion = nearest_name(value, known),
                      .rule = Rule::figure_selection});
        }
    }
}

}  // namespace kreisel
