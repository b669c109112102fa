// SPDX-License-Identifier: BSD-3-Clause
//
// What methods preserve: one row per method, problem, formulation and projection.
#include "plots/laws/structure.hpp"
#include "records/reading/trajectory_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "plots/laws/convergence.hpp"
#include "plots/laws/growth.hpp"
#include "plots/tables/cells.hpp"
#include "plots/tables/table.hpp"
#include "records/metrics/catalogue.hpp"

namespace kreisel {

namespace {

const std::vector<std::string> structure_notes = {
    "Two-form, reversal: kept where at no step size the defect of a step is above ten times its uncertainty, at three "
    "sizes at least; else the observed power of h, over the three smallest steps; \"-\" where it is not defined.",
    "Energy: of the largest |E - E_0| so far, at the smallest step: bounded where it has stopped growing, else its "
    "growth "
    "law; momenta, constraints: the largest relative deviation of a momentum and the largest defect of a constraint; "
    "kept: "
    "up to 1e4 units of round-off, or for the energy what round-off adds up to."};

std::vector<std::string> structure_metrics() {
    std::vector<std::string> names;
    for (const MetricDescription& metric : metric_catalogue()) {
        if (is_structure(metric)) { names.push_back(metric.name); }
    }
    return names;
}

std::string energy_text(const ResultRow& row) {
    const std::string energy = "invariant.energy";
    const auto value = row.metrics.find(energy);
    if (value == row.metrics.end()) { return "-"; }
    if (!row.has_trajectory) { return short_number(value->second); }
    const TrajectoryTable trajectory = read_trajectory(row);
    if (value->second <= roundoff_level(trajectory, row.precision)) { return "kept"; }
    const auto law = growth_of(trajectory, energy, row.precision);
    if (!law) { return "no law"; }
    return std::abs(law->exponent) < 0.1 ? "bounded" : fmt::format("t^{:.2f}", law->exponent);
}

// The largest of these values, in words where it is round-off.
std::string largest_text(const std::vector<double>& values, const std::string& precision) {
    if (values.empty()) { return "-"; }
    const double largest = *std::max_element(values.begin(), values.end());
    return largest <= 1e4 * epsilon_of(precision) ? "kept" : short_number(largest);
}

std::string momenta_text(const ResultRow& row) {
    std::vector<double> values;
    for (const auto& [name, value] : row.metrics) {
        const bool momentum = name.starts_with("invariant.angular_momentum") || name.starts_with("invariant.momentum");
        if (momentum && name.ends_with(".relative")) { values.push_back(value); }
    }
    return largest_text(values, row.precision);
}

std::string largest_constraint_defect(const ResultRow& row) {
    std::vector<double> values;
    for (const char* name : {"defect.position", "defect.direction", "defect.velocity", "defect.direction.velocity"}) {
        if (const auto value = row.metrics.find(name); value != row.metrics.end()) { values.push_back(value->second); }
    }
    return largest_text(values, row.precision);
}

TextTable structure_in_brief(const Results& results) {
    const CellNames names(results.rows);
    TextTable table = cell_table("structure", "What is preserved: " + results.name,
                                 {"two-form", "reversal", "energy", "momenta", "constraints"});
    table.notes = structure_notes;
    for (const CellGroup& group : group_by_method(results.rows)) {
        const ResultRow* best = finest(group);
        if (best == nullptr) { continue; }
        add_row(table, names, *best,
                {structure_text(structure_of(group, "structure.symplectic")),
                 structure_text(structure_of(group, "structure.reversal")), energy_text(*best), momenta_text(*best),
                 largest_constraint_defect(*best)});
    }
    return without_constant_columns(table, CellNames::axes());
}

// One row per group and metric of steps.
TextTable structure_in_full(const Results& results) {
    const CellNames names(results.rows);
    TextTable table =
        cell_table("structure", "What is preserved: " + results.name,
                   {"metric", "verdict", "order", "spread", "largest", "uncertainty", "step_sizes", "remark"});
    for (const CellGroup& group : group_by_method(results.rows)) {
        for (const std::string& metric : structure_metrics()) {
            const StructureLaw law = structure_of(group, metric);
            if (law.steps == 0 && law.why_not.empty()) { continue; }
            add_row(table, names, group.front(),
                    {metric, structure_text(law), law.order ? exact_number(*law.order) : "",
                     law.order ? exact_number(law.spread) : "", law.largest > 0 ? exact_number(law.largest) : "",
                     law.steps > 0 ? exact_number(law.uncertainty) : "", fmt::format("{}", law.steps), law.why_not});
        }
    }
    return table;
}

std::vector<TablePair> structure_tables(const Results& results) {
    return one_table(structure_in_full(results), structure_in_brief(results));
}

}  // namespace

KREISEL_TABLE({.name = "structure",
               .summary = "what methods preserve: two-form, reversal, energy, momenta, constraints",
               .place = 27,
               .applies = has_structures,
               .is_printed = always,
               .make = structure_tables});

}  // namespace kreisel
