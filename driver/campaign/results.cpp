// SPDX-License-Identifier: BSD-3-Clause
#include "driver/campaign/results.hpp"

#include <fmt/format.h>

#include "driver/config/resolved.hpp"
#include "driver/plan/shards.hpp"
#include "driver/plan/text.hpp"
#include "records/cell/stepping.hpp"
#include "records/cell/table.hpp"
#include "records/sums/sum_list.hpp"
#include "support/files.hpp"
#include "support/number_text.hpp"

namespace kreisel {

namespace {

/// Of the metrics.
Units units_of(const Plan& plan) {
    std::vector<IntegralDescription> integrals;
    for (const auto& [key, system] : plan.systems) {
        integrals.insert(integrals.end(), system.integrals.begin(), system.integrals.end());
    }
    return units_of_metrics(integrals);
}

}  // namespace

void write_results(const Plan& plan, const std::map<std::string, CellRecord>& finished, const TableUnits& units,
                   const std::filesystem::path& folder) {
    std::vector<CellRecord> records;
    std::string text;
    for (const PlannedCell& planned : plan.cells) {
        const auto found = finished.find(planned.hash());
        if (found == finished.end()) { continue; }
        records.push_back(found->second);
        records.back().identity = planned.identity();  // its label may have changed since
        text += result_line(records.back()) + "\n";
    }
    write_atomically(folder / "results.jsonl", text);
    announce_files(folder, {"results.csv"});
    write_atomically(folder / "results.csv", results_table(records, units));
    record_sums(folder, {"results.csv"});
}

ManifestSubject manifest_subject(const Plan& plan) {
    return {plan.config.name, plan.warnings, resolved_config(plan.config), units_of(plan)};
}

TableUnits table_units(const Plan& plan, const Engine& engine) {
    TableUnits units{units_of(plan), {}};
    for (const ProblemDescription& problem : engine.problems()) {
        for (const ParameterDescription& parameter : problem.parameters) {
            units.parameters[problem.name][parameter.name] = parameter.unit;
        }
    }
    return units;
}

CellCounts count_cells(const Plan& plan, const std::map<std::string, CellRecord>& finished,
                       const RunSettings& settings) {
    CellCounts counts;
    for (const std::size_t i : cells_of_shard(plan, settings.shard, settings.shards)) {
        const auto found = finished.find(plan.cells[i].hash());
        ++counts.total;
        if (found == finished.end()) {
            ++counts.missing;
        } else if (found->second.outcome.failed()) {
            ++counts.failed;
        } else {
            ++(found->second.outcome.status == "ok" ? counts.ok : counts.skipped);
        }
    }
    return counts;
}

std::string cell_text(const PlannedCell& planned) {
    const Cell& cell = planned.cell();
    const auto with_options = [](const std::string& name, const OptionValues& options) {
        return options.empty() ? name : name + " " + options_text(options);
    };
    return fmt::format("{} on {} {}, projection {}, {}, {}", with_options(cell.method, cell.options), planned.label(),
                       cell.formulation, with_options(cell.projection, cell.projection_options), planned.precision(),
                       stepping_text(cell));
}

std::string failure_text(const PlannedCell& planned, const CellOutcome& outcome) {
    return fmt::format("{} at t = {}: {}: {}", outcome.status, brief_text(outcome.t_reached), cell_text(planned),
                       outcome.detail.empty() ? "no details" : outcome.detail);
}

}  // namespace kreisel
