// SPDX-License-Identifier: BSD-3-Clause
#include "driver/campaign/results.hpp"

#include <fmt/format.h>

#include "driver/config/resolved.hpp"
#include "driver/plan/text.hpp"
#include "records/csv.hpp"
#include "support/files.hpp"

namespace kreisel {

void write_results(const Plan& plan, const std::map<std::string, FinishedCell>& finished,
                   const std::filesystem::path& folder) {
    std::vector<std::string> lines;
    std::string text;
    for (const PlannedCell& planned : plan.cells) {
        const auto found = finished.find(planned.hash);
        if (found != finished.end()) {
            lines.push_back(relabelled(found->second.line, planned));
            text += lines.back() + "\n";
        }
    }
    write_atomically(folder / "results.jsonl", text);
    write_atomically(folder / "results.csv", results_table(lines));
}

ManifestSubject manifest_subject(const Plan& plan) {
    return {plan.config.name, plan.warnings, resolved_config(plan.config)};
}

CellCounts count_cells(const Plan& plan, const std::map<std::string, FinishedCell>& finished,
                       const RunSettings& settings) {
    CellCounts counts;
    for (std::size_t i = settings.shard - 1; i < plan.cells.size(); i += settings.shards) {
        const auto found = finished.find(plan.cells[i].hash);
        ++counts.total;
        if (found == finished.end()) {
            ++counts.missing;
        } else if (found->second.failed()) {
            ++counts.failed;
        } else {
            ++(found->second.status == "ok" ? counts.ok : counts.skipped);
        }
    }
    return counts;
}

std::string failure_text(const PlannedCell& planned, const FinishedCell& finished) {
    const Cell& cell = planned.cell;
    const auto with_options = [](const std::string& name, const OptionValues& options) {
        return options.empty() ? name : name + " " + options_text(options);
    };
    return fmt::format("{} at t = {:.10g}: {} on {} {}, projection {}, {}, {} steps: {}", finished.status,
                       finished.t_reached, with_options(cell.method, cell.options), planned.label, cell.formulation,
                       with_options(cell.projection, cell.projection_options), planned.precision, cell.steps,
                       finished.detail.empty() ? "no details" : finished.detail);
}

}  // namespace kreisel
