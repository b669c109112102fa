// SPDX-License-Identifier: BSD-3-Clause
#include "driver/campaign/dispatch/ledger.hpp"

#include "driver/plan/shards.hpp"
#include "records/cell/line.hpp"
#include "records/trajectory_file.hpp"
#include "support/errors.hpp"
#include "support/hash.hpp"

namespace kreisel {

namespace {

void keep_fastest(CellTimes& times, double run_s) {
    if (!times.run_s || run_s >= *times.run_s) { return; }
    if (times.step_s) { times.step_s = *times.step_s * (run_s / *times.run_s); }
    times.run_s = run_s;
}

}  // namespace

Ledger::Ledger(const Plan& plan, std::filesystem::path folder, const RunSettings& settings)
    : plan_(plan),
      folder_(std::move(folder)),
      build_(settings.build),
      journal_(journal_file(folder_, shard_name(settings))) {}

bool Ledger::trajectory_is_whole(const CellRecord& cell) const {
    std::error_code error;
    const auto file = folder_ / trajectory_file(cell.identity.cell);
    const std::string& sum = cell.outcome.trajectory_sum;
    return sum.empty() || (std::filesystem::is_regular_file(file, error) && hash_text(read_text(file)) == sum);
}

std::size_t Ledger::reuse(const JournalContents& earlier, const RunSettings& settings) {
    for (const std::size_t i : cells_of_shard(plan_, settings.shard, settings.shards)) {
        const auto found = earlier.cells.find(plan_.cells[i].hash());
        const bool whole = found != earlier.cells.end() && !status::is_tried_again(found->second.outcome.status) &&
                           trajectory_is_whole(found->second);
        if (whole) {
            finished_.insert(*found);
            progress.failed += found->second.outcome.failed() ? 1U : 0U;
        } else {
            mine_.push_back(i);
            progress.weight_total += plan_.cells[i].weight;
        }
    }
    progress.done = finished_.size();
    progress.total = finished_.size() + mine_.size();
    return finished_.size();
}

void Ledger::record(std::size_t index, const std::string& line) {
    auto cell = read_journal_line(line);
    if (!cell || cell->record.identity.cell != plan_.cells[index].hash()) {
        throw std::logic_error("a worker answered with a line that is not of its cell");
    }
    keep(index, std::move(cell->record), line);
}

void Ledger::record(std::size_t index, const Outcome& outcome) {
    const PlannedCell& planned = plan_.cells[index];
    TrajectoryFile(folder_ / trajectory_file(planned.hash())).discard();
    CellRecord cell = record_of(planned, outcome, nullptr);
    const std::string line = journal_line(cell, build_);
    keep(index, std::move(cell), line);
}

void Ledger::keep(std::size_t index, CellRecord cell, const std::string& line) {
    journal_.append(line);
    progress.weight_done += plan_.cells[index].weight;
    progress.failed += cell.outcome.failed() ? 1U : 0U;
    finished_.insert_or_assign(plan_.cells[index].hash(), std::move(cell));
    progress.done = finished_.size();
}

std::vector<std::size_t> Ledger::timed_cells() {
    std::vector<std::size_t> cells;
    for (const std::size_t index : mine_) {
        const auto found = finished_.find(plan_.cells[index].hash());
        const bool ok = found != finished_.end() && found->second.outcome.status == status::ok;
        if (!ok || !found->second.times.run_s) { continue; }
        cells.push_back(index);
        progress.weight_total += (timing_rounds - 1) * plan_.cells[index].weight;
    }
    return cells;
}

void Ledger::note_seconds(std::size_t index, std::optional<double> run_s) {
    if (run_s) { keep_fastest(finished_.at(plan_.cells[index].hash()).times, *run_s); }
    progress.weight_done += plan_.cells[index].weight;
}

void Ledger::record_times(const std::vector<std::size_t>& cells) {
    for (const std::size_t index : cells) {
        journal_.append(journal_line(finished_.at(plan_.cells[index].hash()), build_));
    }
}

}  // namespace kreisel
