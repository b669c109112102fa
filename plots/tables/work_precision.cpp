// SPDX-License-Identifier: BSD-3-Clause
//
// What each method takes to reach an accuracy, and which of them takes least.
#include "plots/laws/work_precision.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "plots/laws/convergence.hpp"
#include "plots/tables/cells.hpp"
#include "plots/tables/table.hpp"
#include "records/kinds/kind.hpp"

namespace kreisel {

namespace {

using Costs = std::vector<std::optional<CostAtAccuracy>>;  ///< by group

const std::vector<std::string> work_precision_notes = {
    "The lowest cost at which the error falls to the accuracy in the head of the column, by interpolation of the "
    "logarithms between neighbouring cells, never extrapolated. An asterisk marks the lowest on the problem, \"<=\" an "
    "upper bound: the cheapest cell is more accurate already, or has no error. CPU times are means over the "
    "runs of the fastest of five rounds, and depend on the machine and its load."};

bool is_of_costs(const Results& results) {
    const ExperimentKind* kind = find_experiment_kind(results.kind);
    return kind != nullptr && kind->repeated && !results.rows.empty();
}

/// Costs are compared on one problem, and its precision.
bool compete(const CellGroup& one, const CellGroup& other) {
    const ResultRow &a = one.front(), &b = other.front();
    return a.problem == b.problem && a.label == b.label && a.parameters == b.parameters && a.t_end == b.t_end &&
           a.precision == b.precision;
}

Costs costs_at(const std::vector<CellGroup>& groups, const std::string& metric, const std::string& cost,
               double accuracy) {
    Costs all;
    for (const CellGroup& group : groups) { all.push_back(cost_at(work_points(group, metric, cost), accuracy)); }
    return all;
}

/// Whether no group on the problem of group i takes less.
bool is_lowest(const Costs& costs, const std::vector<CellGroup>& groups, std::size_t i) {
    for (std::size_t k = 0; k < groups.size() && costs[i]; ++k) {
        if (costs[k] && compete(groups[k], groups[i]) && costs[k]->cost < costs[i]->cost) { return false; }
    }
    return costs[i].has_value();
}

/// All metrics but the figures beside the plain ones (".final", ".slope").
std::vector<std::string> tabulated_metrics(const Results& results) {
    std::vector<std::string> metrics = error_metrics(results.rows);
    for (const char* family : {"defect.", "invariant."}) {
        metrics = with(metrics, plain_metrics(results.rows, family));
    }
    return metrics;
}

/// One row per group, metric, cost and accuracy.
TextTable work_precision_in_full(const Results& results, const std::vector<CellGroup>& groups) {
    const CellNames names(results.rows);
    TextTable table = cell_table("work_precision", "Cost of an accuracy: " + results.name,
                                 {"metric", "unit", "accuracy", "cost", "value", "bound", "lowest"});
    for (const std::string& metric : tabulated_metrics(results)) {
        for (const Abscissa& cost : costs()) {
            for (const double accuracy : tabulated_accuracies) {
                const Costs all = costs_at(groups, metric, cost.name, accuracy);
                for (std::size_t i = 0; i < groups.size(); ++i) {
                    if (work_points(groups[i], metric, cost.name).empty()) { continue; }
                    add_row(table, names, groups[i].front(),
                            {metric, metric_unit(metric, results.units), exact_number(accuracy), cost.name,
                             all[i] ? exact_number(all[i]->cost) : "",
                             !all[i]           ? "not reached"
                             : all[i]->at_most ? "at most"
                                               : "",
                             is_lowest(all, groups, i) ? "yes" : ""});
                }
            }
        }
    }
    return table;
}

std::string cost_cell(const Costs& costs, const std::vector<CellGroup>& groups, std::size_t i) {
    if (!costs[i]) { return "not reached"; }
    return (costs[i]->at_most ? "<= " : "") + short_number(costs[i]->cost) + (is_lowest(costs, groups, i) ? "*" : "");
}

/// One row per group and cost, solves and CPU time only; errors of the first metric.
TextTable work_precision_in_brief(const Results& results, const std::vector<CellGroup>& groups) {
    const CellNames names(results.rows);
    const auto metrics = tabulated_metrics(results);
    const std::string metric = metrics.empty() ? "" : metrics.front();
    std::vector<std::string> columns = {"cost"};
    for (const double accuracy : tabulated_accuracies) { columns.push_back(fmt::format("{:.0e}", accuracy)); }
    const std::string unit = metric.empty() ? "" : " [" + metric_unit(metric, results.units) + "]";
    TextTable table = cell_table("work_precision",
                                 fmt::format("Cost of an accuracy of {}{}: {}", metric, unit, results.name), columns);
    table.notes = work_precision_notes;
    for (const char* cost : {"evaluations", "cpu"}) {
        std::vector<Costs> all;
        for (const double accuracy : tabulated_accuracies) { all.push_back(costs_at(groups, metric, cost, accuracy)); }
        for (std::size_t i = 0; i < groups.size(); ++i) {
            if (work_points(groups[i], metric, cost).empty()) { continue; }
            std::vector<std::string> cells = {abscissa_label(cost)};
            for (const Costs& one : all) { cells.push_back(cost_cell(one, groups, i)); }
            add_row(table, names, groups[i].front(), cells);
        }
    }
    return table;
}

std::vector<TablePair> work_precision_tables(const Results& results) {
    const std::vector<CellGroup> groups = group_by_method(results.rows);
    return one_table(work_precision_in_full(results, groups), work_precision_in_brief(results, groups));
}

}  // namespace

KREISEL_TABLE({.name = "work_precision",
               .summary = "what accuracies of 1e-3, 1e-6, 1e-9 and 1e-12 cost, and who takes least",
               .place = 25,
               .applies = is_of_costs,
               .is_printed = always,
               .make = work_precision_tables});

}  // namespace kreisel
