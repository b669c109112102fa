// SPDX-License-Identifier: BSD-3-Clause
#include "driver/campaign/dispatch/ledger.hpp"

#include <algorithm>

#include "driver/plan/shards.hpp"
#include "records/cell/line.hpp"
#include "records/folder/damage.hpp"
#include "records/trajectory_file.hpp"

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
      journal_(journal_file(folder_, shard_name(settings))),
      finished_(plan.cells.size()),
      number_(finished_.add_journal(journal_file(folder_, shard_name(settings)))) {}

bool Ledger::samples_hold(const CellRecord& cell) {
    const std::string& sum = cell.outcome.trajectory_sum;
    std::string damage = sum.empty() ? "" : trajectory_damage(folder_, cell.identity.cell, sum);
    if (damage.empty()) { return true; }
    damage_.push_back(std::move(damage));
    return false;
}

bool Ledger::take_over(std::size_t index, const CellRecord& cell, const JournalPlace& place) {
    if (status::is_tried_again(cell.outcome.status) || !samples_hold(cell)) { return false; }
    finished_.set(index, ending_of(cell.outcome), place);
    progress.failed += cell.outcome.failed() ? 1U : 0U;
    return true;
}

std::size_t Ledger::reuse(const JournalContents& earlier, const RunSettings& settings) {
    const std::uint32_t first = number_ + 1;  // of the journals that are added here
    for (const auto& file : earlier.files) { finished_.add_journal(file); }
    const JournalLines lines = earlier.lines();
    for (const std::size_t i : cells_of_shard(plan_, settings.shard, settings.shards)) {
        const auto found = earlier.cells.find(plan_.cells[i].hash());
        const JournalPlace place = found == earlier.cells.end() ? JournalPlace() : found->second;
        if (found != earlier.cells.end() &&
            take_over(i, lines.record(place), {first + place.file, place.size, place.begin})) {
            continue;
        }
        mine_.push_back(i);
    }
    progress.done = finished_.size();
    progress.total = finished_.size() + mine_.size();
    return finished_.size();
}

void Ledger::record(std::size_t index, const CellEnding& ending, const std::string& line) {
    if (ending.end == CellEnd::missing || !is_line_of(line, plan_.cells[index].hash())) {
        throw std::logic_error("a worker answered with a line that is not of its cell");
    }
    keep(index, ending, line);
}

void Ledger::record(std::size_t index, const Outcome& outcome) {
    const PlannedCell& planned = plan_.cells[index];
    TrajectoryFile(folder_ / trajectory_file(planned.hash())).discard();
    const CellRecord cell = record_of(planned, outcome, nullptr);
    keep(index, ending_of(cell.outcome), journal_line(cell, build_));
}

void Ledger::append(std::size_t index, const CellEnding& ending, const std::string& line) {
    const std::uint64_t begin = journal_.append(line);
    finished_.set(index, ending, {number_, static_cast<std::uint32_t>(line.size()), begin});
}

void Ledger::keep(std::size_t index, const CellEnding& ending, const std::string& line) {
    append(index, ending, line);
    progress.failed += ending.end == CellEnd::failed ? 1U : 0U;
    progress.done = finished_.size();
}

std::vector<std::size_t> Ledger::timed_cells() {
    std::vector<std::size_t> cells;
    for (const std::size_t index : mine_) {
        if (finished_.end(index) != CellEnd::ok) { continue; }
        const auto run_s = finished_.record(index).times.run_s;
        if (!run_s) { continue; }
        run_s_[index] = *run_s;
        cells.push_back(index);
    }
    return cells;
}

void Ledger::note_seconds(std::size_t index, std::optional<double> run_s) {
    if (run_s) { run_s_.at(index) = std::min(run_s_.at(index), *run_s); }
}

void Ledger::record_times(const std::vector<std::size_t>& cells) {
    for (const std::size_t index : cells) {
        CellRecord cell = finished_.record(index);
        keep_fastest(cell.times, run_s_.at(index));
        append(index, ending_of(cell.outcome), journal_line(cell, build_));
    }
}

}  // namespace kreisel
