// SPDX-License-Identifier: BSD-3-Clause
#include "driver/cli/published/runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <sstream>

#include "driver/config/composition/composed.hpp"
#include "driver/config/shipped.hpp"
#include "plots/laws/convergence.hpp"
#include "records/json/strict.hpp"
#include "records/reading/read_results.hpp"
#include "support/csv.hpp"
#include "support/errors.hpp"
#include "support/files.hpp"

namespace kreisel {

namespace {

using CellLine = std::map<std::string, std::string>;  ///< a line of results.csv by the titles of its columns

std::vector<CellLine> lines_of(const std::filesystem::path& folder) {
    const auto table = read_csv(read_text(folder / "results.csv"));
    std::vector<CellLine> lines;
    for (std::size_t i = 1; i < table.size(); ++i) {
        CellLine& line = lines.emplace_back();
        for (std::size_t k = 0; k < table[0].size() && k < table[i].size(); ++k) { line[table[0][k]] = table[i][k]; }
    }
    return lines;
}

// "steps=2000 formulation=SE3".
bool counts(const CellLine& line, const std::string& cells) {
    std::istringstream words(cells);
    std::string word;
    while (words >> word) {
        const std::size_t equals = word.find('=');
        const auto entry = line.find(word.substr(0, equals));
        if (entry == line.end() || equals == std::string::npos || entry->second != word.substr(equals + 1)) {
            return false;
        }
    }
    return true;
}

std::optional<long double> number_in(const CellLine& line, const std::string& title) {
    const auto entry = line.find(title);
    return entry == line.end() || entry->second.empty() ? std::nullopt : std::optional(std::stold(entry->second));
}

// Component K of R omega, of "space.BODY.omega.K [rad/s]".
std::optional<long double> spin_in_space(const CellLine& line, const std::string& column) {
    const std::size_t end = column.find(".omega.");
    if (end == std::string::npos) { return std::nullopt; }
    const std::string body = "final." + column.substr(6, end - 6), k = column.substr(end + 7, 1);
    long double sum = 0;
    for (const char* j : {"1", "2", "3"}) {
        const auto R = number_in(line, fmt::format("{}.R.{}.{} [1]", body, k, j));
        const auto omega = number_in(line, fmt::format("{}.omega.{} [rad/s]", body, j));
        if (!R || !omega) { return std::nullopt; }
        sum += *R * *omega;
    }
    return sum;
}

std::optional<std::string> quantity_of(const CellLine& line, const std::string& column) {
    std::optional<long double> derived;
    if (column.starts_with("space.")) {
        derived = spin_in_space(line, column);
    } else if (column == "initial.energy [J]") {
        const auto drift = number_in(line, "invariant.energy [J]"),
                   share = number_in(line, "invariant.energy.relative [1]");
        if (drift && share && *share > 0) { derived = *drift / *share; }
    } else {
        const auto entry = line.find(column);
        return entry == line.end() || entry->second.empty() ? std::nullopt : std::optional(entry->second);
    }
    return derived ? std::optional(fmt::format("{:.21Lg}", *derived)) : std::nullopt;
}

}  // namespace

std::vector<std::string> PublishedRuns::find(const PublishedValue& value) {
    const std::string& column = value.column;
    const std::vector<std::string> found = column.starts_with("eigenvalue.") ? eigenvalues(value)
                                           : column.starts_with("order.")    ? orders(value)
                                                                             : cells(value);
    if (found.empty()) {
        throw UsageError(fmt::format("{}: expected a cell that is ok{}{}, with a column {}", value.config,
                                     value.cells.empty() ? "" : ", of ", value.cells, column));
    }
    return found;
}

const Plan& PublishedRuns::plan(const std::string& config) {
    const auto known = plans_.find(config);
    if (known != plans_.end()) { return known->second; }
    return plans_.emplace(config, plan_of(composed_config(config_file(config)), engines_)).first->second;
}

std::filesystem::path PublishedRuns::folder_of(const std::string& config) {
    std::filesystem::path& folder = folders_[config];
    if (folder.empty()) {
        run_plan(plan(config), folder_.path() / config, engines_, messages_);
        folder = folder_.path() / config;
    }
    return folder;
}

std::vector<std::string> PublishedRuns::cells(const PublishedValue& value) {
    std::vector<std::string> found;
    for (const CellLine& line : lines_of(folder_of(value.config))) {
        if (line.at("status") != "ok" || !counts(line, value.cells)) { continue; }
        if (auto one = quantity_of(line, value.column)) { found.push_back(std::move(*one)); }
    }
    return found;
}

// A refinement counts if its cells do; one without an order has none.
std::vector<std::string> PublishedRuns::orders(const PublishedValue& value) {
    std::vector<std::string> found;
    Results results = read_results(folder_of(value.config));
    const auto lines = lines_of(folder_of(value.config));
    const auto line_of = [&](const ResultRow& row) {
        return std::find_if(lines.begin(), lines.end(),
                            [&](const CellLine& line) { return line.at("cell") == row.cell; });
    };
    std::erase_if(results.rows, [&](const ResultRow& row) {
        const auto line = line_of(row);
        return !row.ok() || line == lines.end() || !counts(*line, value.cells);
    });
    for (const CellGroup& group : group_by_method(results.rows)) {
        const ObservedOrder observed = order_of(group, value.column.substr(6));
        if (observed.order) { found.push_back(fmt::format("{:.4f}", *observed.order)); }
    }
    return found;
}

// "eigenvalue.3.real": the third.
std::vector<std::string> PublishedRuns::eigenvalues(const PublishedValue& value) {
    std::istringstream words(value.column.substr(value.column.find('.') + 1));
    std::size_t place = 0;
    char dot = 0;
    std::string part;
    words >> place >> dot >> part;
    std::vector<std::string> found;
    for (const Linearisation& one : linearised(value.config)) {
        if (place < 1 || place > one.eigenvalues.size()) { continue; }
        const Eigenvalue& eigenvalue = one.eigenvalues[place - 1];
        found.push_back(part == "imaginary" ? eigenvalue.imaginary.text : eigenvalue.real.text);
    }
    return found;
}

const std::vector<Linearisation>& PublishedRuns::linearised(const std::string& config) {
    std::vector<Linearisation>& all = linearised_[config];
    if (!all.empty()) { return all; }
    const Config& read = plan(config).config;
    for (const ProblemPoint& problem : read.problems) {
        for (const std::string& formulation : read.formulations) {
            all.push_back(
                engines_.quad().linearise(problem.name(), problem.parameters(), formulation, read.begin.get()));
        }
    }
    return all;
}

}  // namespace kreisel
