// SPDX-License-Identifier: BSD-3-Clause
#include "driver/config/composition/filter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <sstream>

#include "records/json/diagnostics.hpp"
#include "support/errors.hpp"
#include "support/nearest.hpp"
#include "support/pattern.hpp"

namespace kreisel {

namespace {

std::string did_you_mean(const std::string& word, const std::vector<std::string>& names) {
    const std::string nearest = nearest_name(word, names);
    return nearest.empty() ? "" : "; did you mean " + in_quotes(nearest) + "?";
}

std::vector<std::string> separated(const std::string& text) {
    std::vector<std::string> parts;
    std::istringstream stream(text);
    for (std::string part; std::getline(stream, part, ',');) { parts.push_back(part); }
    return parts;
}

/// `names_of` an entry: those by which it may be called.
template <class Entry, class Names>
void leave(const std::string& filter, const std::string& patterns, std::vector<Entry>& entries, Names names_of) {
    const std::vector<std::string> wanted = separated(patterns);
    std::vector<std::string> known;
    std::vector<Entry> left;
    for (Entry& entry : entries) {
        const std::vector<std::string> names = names_of(entry);
        known.insert(known.end(), names.begin(), names.end());
        const auto fits = [&](const std::string& name) { return matches_any(wanted, name); };
        if (std::any_of(names.begin(), names.end(), fits)) { left.push_back(entry); }
    }
    if (left.empty()) {
        std::sort(known.begin(), known.end());
        known.erase(std::unique(known.begin(), known.end()), known.end());
        throw UsageError(fmt::format("--filter {}: nothing fits; there are {}{}", in_quotes(filter), listed(known),
                                     did_you_mean(patterns, known)));
    }
    entries = std::move(left);
}

void apply_filter(const std::string& filter, Config& config) {
    static const std::vector<std::string> axes = {"problems", "formulations", "methods", "projections", "precision"};
    const std::size_t equals = filter.find('=');
    const std::string axis = filter.substr(0, equals);
    const std::string patterns = equals == std::string::npos ? "" : filter.substr(equals + 1);
    const auto itself = [](const std::string& name) { return std::vector<std::string>{name}; };
    const auto by_name = [](const OptionedEntry& entry) { return std::vector<std::string>{entry.name}; };
    const bool known = std::find(axes.begin(), axes.end(), axis) != axes.end();
    if (patterns.empty() || !known) {
        throw UsageError(fmt::format("--filter {}: expected AXIS=PATTERN with one of the axes {}{}", in_quotes(filter),
                                     listed(axes), known ? "" : did_you_mean(axis, axes)));
    }
    if (axis == "problems") {
        leave(filter, patterns, config.problems, [](const ProblemPoint& problem) {
            return std::vector<std::string>{problem.name(), problem.series_label()};
        });
    }
    if (axis == "formulations") { leave(filter, patterns, config.formulations, itself); }
    if (axis == "methods") { leave(filter, patterns, config.methods, by_name); }
    if (axis == "projections") { leave(filter, patterns, config.projections, by_name); }
    if (axis == "precision") { leave(filter, patterns, config.precisions, itself); }
}

}  // namespace

void apply_filters(const std::vector<std::string>& filters, Config& config) {
    if (!filters.empty()) { config.whole = std::make_shared<const Config>(config); }
    for (const std::string& filter : filters) { apply_filter(filter, config); }
}

}  // namespace kreisel
