// SPDX-License-Identifier: BSD-3-Clause
#include "plots/diff/names.hpp"

#include <fmt/format.h>

#include "plots/tables/text.hpp"

namespace kreisel {

namespace {

std::string told(const RecordedCell& cell, const std::string& name) {
    const auto found = cell.identity.find(name);
    return found == cell.identity.end() ? "" : found->second;
}

/// "1000", or "to 1e-06 by pi".
std::string told_steps(const RecordedCell& cell) {
    const std::string tolerance = told(cell, "tolerance");
    return tolerance.empty() ? told(cell, "steps") : fmt::format("to {} by {}", tolerance, told(cell, "controller"));
}

/// "coordinates=exp dexpinv=exact" of the members "options.coordinates" and "options.dexpinv".
std::string told_options(const RecordedCell& cell, const std::string& prefix) {
    std::string text;
    for (const auto& [name, value] : cell.identity) {
        if (!name.starts_with(prefix)) { continue; }
        text += fmt::format("{}{}={}", text.empty() ? "" : " ", name.substr(prefix.size()), value);
    }
    return text;
}

std::string name_and_options(const std::string& name, const std::string& options) {
    return options.empty() ? name : name + " " + options;
}

}  // namespace

const std::vector<std::string>& short_cell_columns() {
    static const std::vector<std::string> columns = {"cell",       "problem",   "formulation", "method",
                                                     "projection", "precision", "steps",       "t_end [s]"};
    return columns;
}

std::vector<std::string> shared_cell_columns() {
    const auto& all = short_cell_columns();
    return {all.begin() + 1, all.end()};
}

std::vector<std::string> short_cell(const RecordedCell& cell) {
    return {cell.cell,
            cell.label,
            told(cell, "formulation"),
            name_and_options(told(cell, "method"), told_options(cell, "options.")),
            name_and_options(told(cell, "projection"), told_options(cell, "projection_options.")),
            told(cell, "precision"),
            told_steps(cell),
            told(cell, "t_end")};
}

const std::vector<std::string>& full_cell_columns() {
    static const std::vector<std::string> columns = {"problem", "label",      "formulation",        "method",
                                                     "options", "projection", "projection options", "precision",
                                                     "steps",   "t_end [s]"};
    return columns;
}

std::vector<std::string> full_cell(const RecordedCell& cell) {
    return {told(cell, "problem"),
            cell.label,
            told(cell, "formulation"),
            told(cell, "method"),
            told_options(cell, "options."),
            told(cell, "projection"),
            told_options(cell, "projection_options."),
            told(cell, "precision"),
            told_steps(cell),
            told(cell, "t_end")};
}

std::string ulp_text(double ulps) {
    if (ulps == 0) { return "-"; }
    return ulps < 1e6 ? fmt::format("{:.6g}", ulps) : fmt::format("{:.1e}", ulps);
}

std::string number_or_dash(double value) { return value == 0 ? "-" : short_number(value); }

std::string text_or_dash(const std::string& text) { return text.empty() ? "-" : text; }

}  // namespace kreisel
