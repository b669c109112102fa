// SPDX-License-Identifier: BSD-3-Clause
#include "driver/campaign/work.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "support/errors.hpp"
#include "support/hash.hpp"

namespace kreisel {

namespace {

// Outcomes that are not due to the numerics only are tried again.
bool is_repeatable(const CellRecord& cell) {
    const std::string& status = cell.outcome.status;
    return status != "exception" && status != "reference_failed" && status != interrupted_status;
}

void keep_fastest(CellTimes& times, double run_s) {
    if (!times.run_s || run_s >= *times.run_s) { return; }
    if (times.step_s) { times.step_s = *times.step_s * (run_s / *times.run_s); }
    times.run_s = run_s;
}

/// What of an outcome is not a finite number; empty: nothing.
std::string not_finite(const Outcome& outcome) {
    for (const auto& [name, number] : outcome.metrics) {
        if (!std::isfinite(number.value)) { return fmt::format("{} is {}", name, number.text); }
    }
    return "";
}

/// A cell whose steps all succeeded, but whose numbers are none: a failure of its own kind, not a missing number.
Outcome checked(Outcome outcome) {
    const std::string what = outcome.status == "ok" ? not_finite(outcome) : "";
    if (what.empty()) { return outcome; }
    outcome.status = "non_finite";
    outcome.detail = what + ", not a finite number";
    std::erase_if(outcome.metrics, [](const auto& metric) { return !std::isfinite(metric.second.value); });
    return outcome;
}

Outcome thrown(const std::string& what) {
    Outcome outcome;
    outcome.status = "exception";
    outcome.detail = what;
    return outcome;
}

}  // namespace

Outcome run_cell(const PlannedCell& planned, const Engine& engine, const Reference* reference,
                 const std::stop_token& stop, SampleSink* samples) {
    try {
        return checked(engine.run(planned.cell, reference, stop, samples));
    } catch (const FileError&) { throw; } catch (const std::exception& error) {
        return thrown(error.what());
    } catch (...) { return thrown("something other than a std::exception was thrown"); }
}

bool Campaign::trajectory_is_whole(const CellRecord& cell) const {
    std::error_code error;
    const auto file = folder_ / trajectory_file(cell.identity.cell);
    const std::string& sum = cell.outcome.trajectory_sum;
    return sum.empty() || (std::filesystem::is_regular_file(file, error) && hash_text(read_text(file)) == sum);
}

std::size_t Campaign::reuse(const JournalContents& earlier, const RunSettings& settings) {
    std::size_t reused = 0;
    for (std::size_t i = settings.shard - 1; i < plan_.cells.size(); i += settings.shards) {
        const auto found = earlier.cells.find(plan_.cells[i].hash);
        if (found != earlier.cells.end() && is_repeatable(found->second) && trajectory_is_whole(found->second)) {
            finished_.insert(*found);
            ++reused;
        } else {
            mine_.push_back(i);
        }
    }
    return reused;
}

void Campaign::enqueue() {
    std::stable_sort(mine_.begin(), mine_.end(),
                     [this](std::size_t a, std::size_t b) { return plan_.cells[a].weight > plan_.cells[b].weight; });
    total_ = finished_.size() + mine_.size();
    std::set<std::string> needed;
    for (const std::size_t index : mine_) {
        const PlannedCell& planned = plan_.cells[index];
        weight_total_ += planned.weight;
        queue_.add_cell(index, planned.reference);
        if (!planned.reference.empty() && needed.insert(planned.reference).second) {
            queue_.add_reference(planned.reference);
        }
    }
    for (const auto& [hash, planned] : plan_.references) {
        if (store_.is_damaged(planned) && needed.insert(hash).second) { queue_.add_reference(hash); }
    }
    references_total_ = needed.size();
}

void Campaign::work(const std::stop_token& token) {
    while (const auto item = queue_.take(token)) {
        if (item->reference.empty()) {
            compute_cell(plan_.cells[item->cell], token);
        } else {
            compute_reference(item->reference, token);
            queue_.reference_done(item->reference);
        }
    }
    if (plan_.config.runs_alone()) { time_in_turn(token); }
}

std::vector<std::size_t> Campaign::timed_cells() {
    const std::lock_guard lock(mutex_);
    std::vector<std::size_t> cells;
    for (const std::size_t index : mine_) {
        const auto found = finished_.find(plan_.cells[index].hash);
        const bool ok = found != finished_.end() && found->second.outcome.status == "ok";
        if (!ok || !found->second.times.run_s) { continue; }
        cells.push_back(index);
        weight_total_ += (timing_rounds - 1) * plan_.cells[index].weight;
    }
    return cells;
}

void Campaign::time_in_turn(const std::stop_token& token) {
    const std::vector<std::size_t> cells = timed_cells();
    for (int round = 1; round < timing_rounds; ++round) {
        for (const std::size_t index : cells) {
            const PlannedCell& planned = plan_.cells[index];
            if (token.stop_requested()) { return; }
            const auto run_s = engines_.of(planned.precision).run_time(planned.cell, token);
            const std::lock_guard lock(mutex_);
            if (run_s) { keep_fastest(finished_.at(planned.hash).times, *run_s); }
            weight_done_ += planned.weight;
        }
    }
    const std::lock_guard lock(mutex_);
    for (const std::size_t index : cells) {
        if (!closed_) { journal_.append(journal_line(finished_.at(plan_.cells[index].hash), build_)); }
    }
}

void Campaign::compute_reference(const std::string& hash, const std::stop_token& token) {
    const PlannedReference& planned = plan_.references.at(hash);
    auto stored = store_.find(planned);
    if (!stored) {
        try {
            const Reference reference = engines_.binary128.reference(planned.problem, planned.parameters, planned.t_end,
                                                                     planned.samples, token);
            if (reference.interrupted) { return; }
            stored = store_.make(planned, reference);
        } catch (const std::exception& error) {
            const std::lock_guard lock(mutex_);
            reference_errors_[hash] = error.what();
            return;
        }
    }
    const std::lock_guard lock(mutex_);
    if (closed_) { return; }
    const std::string complaint = store_.keep(planned, *stored);
    if (cache_complaint_.empty()) { cache_complaint_ = complaint; }
    references_.insert_or_assign(hash, std::move(stored->reference));
}

void Campaign::compute_cell(const PlannedCell& planned, const std::stop_token& token) {
    const Reference* reference = nullptr;
    std::string reference_error;
    if (token.stop_requested()) { return; }  // its reference may have been abandoned
    if (!planned.reference.empty()) {
        const std::lock_guard lock(mutex_);
        const auto found = references_.find(planned.reference);
        reference = found == references_.end() ? nullptr : &found->second;
        reference_error = reference == nullptr ? reference_errors_[planned.reference] : "";
    }
    Outcome outcome;
    TrajectoryFile samples(folder_ / trajectory_file(planned.hash));
    if (!planned.skip_reason.empty()) {
        outcome.status = "skipped";
        outcome.detail = planned.skip_reason;
    } else if (reference == nullptr && !planned.reference.empty()) {
        outcome.status = "reference_failed";
        outcome.detail = reference_error;
    } else {
        outcome = run_cell(planned, engines_.of(planned.precision), reference, token, &samples);
    }
    if (outcome.status == interrupted_status) { return keep_part(planned, samples); }
    record(planned, outcome, reference, samples);
}

void Campaign::keep_part(const PlannedCell& planned, TrajectoryFile& samples) {
    samples.flush();
    if (samples.sum().empty()) { return; }
    Outcome outcome;
    outcome.status = interrupted_status;
    outcome.detail = "its samples so far are in a part of its trajectory";
    const std::lock_guard lock(mutex_);
    if (!closed_) { journal_.append(journal_line(record_of(planned, outcome, nullptr), build_)); }
}

void Campaign::record(const PlannedCell& planned, const Outcome& outcome, const Reference* reference,
                      TrajectoryFile& samples) {
    CellRecord cell = record_of(planned, outcome, reference, outcome.status == "exception" ? "" : samples.sum());
    std::string line;
    try {
        line = journal_line(cell, build_);
    } catch (const std::logic_error& error) {  // a number that is not finite
        cell = record_of(planned, thrown(error.what()), reference);
        line = journal_line(cell, build_);
    }
    samples.flush();
    const std::lock_guard lock(mutex_);
    if (closed_) { return; }
    cell.outcome.trajectory_sum.empty() ? samples.discard() : samples.keep();
    journal_.append(line);
    weight_done_ += planned.weight;
    finished_.insert_or_assign(planned.hash, std::move(cell));
}

void Campaign::fail(const std::exception_ptr& error) {
    {
        const std::lock_guard lock(mutex_);
        error_ = error_ ? error_ : error;
    }
    stop.request_stop();
}

ProgressState Campaign::progress() const {
    const std::lock_guard lock(mutex_);
    const auto failed =
        std::count_if(finished_.begin(), finished_.end(), [](const auto& one) { return one.second.outcome.failed(); });
    return {finished_.size(),
            total_,
            static_cast<std::size_t>(failed),
            references_.size() + reference_errors_.size(),
            references_total_,
            weight_done_,
            weight_total_};
}

}  // namespace kreisel
