// SPDX-License-Identifier: BSD-3-Clause
//
// Whether the energy errors stay bounded or grow: one row per method, problem, formulation and projection.
#include "plots/laws/energy.hpp"

#include <algorithm>

#include "plots/tables/cells.hpp"
#include "plots/tables/table.hpp"

namespace kreisel {

namespace {

const std::vector<std::string> energy_notes = {
    "Law of E - E_0 from two step sizes or more: bounded where at none the secular rate exceeds three standard errors "
    "and what round-off can add, with the power of h of the largest |E - E_0|; else linear, or the power of t, with "
    "the power of h of the rate; kept: no more than round-off; unclear: a trend at some step sizes only. Rate: "
    "least-squares slope of means over 32 parts of the run, at the smallest step; error: three standard errors, for "
    "correlated means, plus round-off."};

bool has_energy_series(const Results& results) {
    return std::any_of(results.rows.begin(), results.rows.end(), [](const ResultRow& row) {
        return row.ok() && !row.adaptive() && row.has_trajectory && row.metrics.contains("invariant.energy");
    });
}

// Beside the table "structure", which says what becomes of the energy, it is not.
bool tells_of_long_times(const Results& results) { return has_no_errors(results) && !has_structures(results); }

// A row for each run.
void add_energy_runs(TextTable& table, const CellNames& names, const CellGroup& group, const EnergyLaw& law) {
    for (const EnergyTrend& trend : law.trends) {
        add_row(table, names, group.front(),
                {energy_text(law), exact_number(trend.h), exact_number(trend.largest), exact_number(trend.slope),
                 exact_number(trend.error), trend.exponent ? exact_number(*trend.exponent) : ""});
    }
}

void add_energy_law(TextTable& table, const CellNames& names, const CellGroup& group, const EnergyLaw& law) {
    const EnergyTrend& finest = law.trends.back();
    add_row(table, names, group.front(),
            {energy_text(law), short_number(finest.h), short_number(finest.largest), short_number(finest.slope),
             short_number(finest.error)});
}

std::vector<TablePair> energy_tables(const Results& results) {
    const CellNames names(results.rows);
    const std::string title = "Energy over long times: " + results.name;
    const std::vector<std::string> columns = {"law", "h [s]", "max |E - E_0| [J]", "rate [J/s]", "error [J/s]"};
    TextTable full = cell_table("energy", title, with(columns, {"exponent"})),
              brief = cell_table("energy", title, columns);
    brief.notes = energy_notes;
    for (const CellGroup& group : group_by_method(results.rows)) {
        const auto law = energy_law_of(group);
        if (!law) { continue; }
        add_energy_runs(full, names, group, *law);
        add_energy_law(brief, names, group, *law);
    }
    return one_table(std::move(full), without_constant_columns(std::move(brief), CellNames::axes()));
}

}  // namespace

KREISEL_TABLE({.name = "energy",
               .summary = "whether energy errors stay bounded or grow, from two step sizes or more",
               .place = 75,
               .applies = has_energy_series,
               .is_printed = tells_of_long_times,
               .make = energy_tables});

}  // namespace kreisel
