// SPDX-License-Identifier: BSD-3-Clause
#include "driver/campaign/results.hpp"

#include <fmt/format.h>

#include <optional>

#include "driver/config/resolved.hpp"
#include "driver/plan/shards.hpp"
#include "driver/plan/text.hpp"
#include "records/cell/line.hpp"
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
    for (const PlannedSystems::Shared& system : plan.systems.kinds()) {
        integrals.insert(integrals.end(), system->integrals.begin(), system->integrals.end());
    }
    return units_of_metrics(integrals);
}

/// Writes results.csv. Rows are right as long as no line has a column that the first has not; then all are written
/// again, when all columns are known.
class TableFile {
  public:
    TableFile(const TableUnits& units, std::filesystem::path path) : table_(units), path_(std::move(path)) {}

    void add(const ResultLine& line) {
        const std::string row = table_.row(line.values());
        if (!file_) { begin_again(); }
        if (is_whole()) { file_->add(row); }
    }
    bool is_whole() const { return file_ && columns_ == table_.columns(); }
    /// With all columns so far.
    void begin_again() {
        columns_ = table_.columns();
        file_.emplace(path_);
        file_->add(table_.header());
    }
    void keep() { file_->keep(); }

  private:
    ResultsTable table_;
    const std::filesystem::path path_;
    std::optional<AtomicFile> file_;
    std::size_t columns_ = 0;
};

/// Visits the lines of results.jsonl in the order of the plan. What was run is told as the plan tells it: labels may
/// have changed since.
template <class Visit>
void for_each_line_of(const Plan& plan, const FinishedCells& finished, const Visit& visit) {
    for (std::size_t i = 0; i < plan.cells.size(); ++i) {
        if (finished.has(i)) { visit(ResultLine(plan.cells[i].identity(), finished.line(i))); }
    }
}

}  // namespace

void write_results(const Plan& plan, const FinishedCells& finished, const TableUnits& units,
                   const std::filesystem::path& folder) {
    AtomicFile lines(folder / "results.jsonl");
    TableFile table(units, folder / "results.csv");
    for_each_line_of(plan, finished, [&](const ResultLine& line) {
        lines.add(line.text());
        lines.add("\n");
        table.add(line);
    });
    // Once each, before it is there: a reader of a run that was killed takes what is announced for unfinished.
    announce_files(folder, {"results.jsonl"});
    lines.keep();
    announce_files(folder, {"results.csv"});
    if (!table.is_whole()) {
        table.begin_again();
        for_each_line_of(plan, finished, [&](const ResultLine& line) { table.add(line); });
    }
    table.keep();
    record_sums(folder, {"results.jsonl", "results.csv"});
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

CellCounts count_cells(const Plan& plan, const FinishedCells& finished, const RunSettings& settings) {
    CellCounts counts;
    for (const std::size_t i : cells_of_shard(plan, settings.shard, settings.shards)) {
        ++counts.total;
        switch (finished.end(i)) {
            case CellEnd::missing:
                ++counts.missing;
                break;
            case CellEnd::ok:
                ++counts.ok;
                break;
            case CellEnd::skipped:
                ++counts.skipped;
                break;
            case CellEnd::failed:
                ++counts.failed;
                break;
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
