// SPDX-License-Identifier: BSD-3-Clause
#include "driver/campaign/dispatch/dispatcher.hpp"

#include <fmt/format.h>
#include <poll.h>

#include <algorithm>
#include <thread>

#include "driver/campaign/cell_run.hpp"
#include "driver/campaign/dispatch/work.hpp"
#include "driver/campaign/interrupt.hpp"
#include "driver/campaign/workers/bad_end.hpp"
#include "driver/plan/cost.hpp"
#include "support/errors.hpp"

namespace kreisel {

namespace {

constexpr int look_up = 50;  // ms after which progress and signals are looked at

// While short cells of a batch end, their answers are taken a few at a time: to be woken for each costs more than some
// cells. Short beside a batch.
constexpr std::chrono::microseconds nap{500};

double seconds_since(std::chrono::steady_clock::time_point time) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - time).count();
}

}  // namespace

void Dispatcher::enqueue(const std::vector<std::string>& references, const std::vector<std::size_t>& cells) {
    for (const std::string& hash : references) {
        schedule_.add_reference(hash);
        efforts_.references.add(plan_.references.at(hash).weight);
    }
    ledger_.progress.references += references.size();
    enqueued_ = ledger_.finished().size() + cells.size();
    for (const std::size_t index : cells) {
        const PlannedCell& planned = plan_.cells[index];
        if (planned.skip_reason().empty()) {
            schedule_.add_cell(index, planned.reference(), planned.weight);
            efforts_.cells.add(planned.weight);
        } else {
            ledger_.record(index, ended(status::skipped, planned.skip_reason()));
        }
    }
}

void Dispatcher::run() {
    while (!given_up_ && (busy() || (!stopped_ && !schedule_.empty()))) {
        watch_interrupt();
        if (!stopped_) { assign(); }
        wait();
        show_(*this);
    }
}

bool Dispatcher::has_left_something() const {
    const ProgressState& progress = ledger_.progress;
    return progress.references_done < progress.references || ledger_.finished().size() < enqueued_;
}

void Dispatcher::time_in_turn() {
    const std::vector<std::size_t> cells = ledger_.timed_cells();
    efforts_.cells.drop_rest();  // cells that failed have no further rounds
    for (int round = 1; round < timing_rounds; ++round) {
        for (const std::size_t index : cells) {
            schedule_.add_round(index);
            efforts_.cells.add(cost_of({Job::Kind::round, {}, {index}}, 0));
        }
    }
    run();
    if (!stopped_) { ledger_.record_times(cells); }
}

double Dispatcher::cost_of(const Job& job, std::size_t at) const {
    if (job.kind == Job::Kind::reference) { return plan_.references.at(job.reference).weight; }
    const PlannedCell& planned = plan_.cells[job.cells[at]];
    const double first = first_round_share(planned);
    return planned.weight * (job.kind == Job::Kind::round ? (1 - first) / (timing_rounds - 1) : first);
}

JobAtWork Dispatcher::at_work(const Slot& slot) const {
    const double told = slot.worker.told != nullptr ? slot.worker.told->load(std::memory_order_relaxed) : 0;
    return {slot.job->kind == Job::Kind::reference, cost_of(*slot.job, slot.answered),
            told - static_cast<double>(slot.given), seconds_since(slot.since)};
}

ProgressState Dispatcher::progress() {
    std::vector<JobAtWork> jobs;
    for (const Slot& slot : slots_) {
        if (slot.job) { jobs.push_back(at_work(slot)); }
    }
    const Outlook expected = outlook(efforts_, jobs, resources_.workers);
    share_shown_ = std::max(share_shown_, expected.share);
    ProgressState state = ledger_.progress;
    state.share = share_shown_;
    state.seconds_left = expected.seconds_left;
    return state;
}

void Dispatcher::account(Slot& slot, Answered kind) {
    ++slot.given;
    if (kind == Answered::interrupted || kind == Answered::part) { return; }
    const double cost = cost_of(*slot.job, slot.answered);
    Effort& effort = effort_of(*slot.job);
    kind == Answered::found ? effort.drop(cost) : effort.end(cost, seconds_since(slot.since));
}

bool Dispatcher::busy() const {
    return std::any_of(slots_.begin(), slots_.end(), [](const Slot& slot) { return slot.job.has_value(); });
}

bool Dispatcher::alone() const {
    return std::any_of(slots_.begin(), slots_.end(), [](const Slot& slot) { return slot.job && slot.job->alone; });
}

void Dispatcher::assign() {
    const auto working = [this] {
        return std::count_if(slots_.begin(), slots_.end(), [](const Slot& slot) { return slot.job.has_value(); });
    };
    while (working() < static_cast<long>(resources_.workers) && !alone()) {
        auto job = schedule_.next(!busy());
        if (!job || !start(std::move(*job))) { return; }
    }
}

bool Dispatcher::start(Job job) {
    Slot* slot = idle_slot(job);
    if (slot == nullptr || !send_message(slot->worker.socket, job.text())) {  // the second is seen by the next wait
        schedule_.give_back(job);
        return false;
    }
    slot->job = std::move(job);
    slot->answered = 0;
    slot->since = Clock::now();
    return true;
}

Dispatcher::Slot* Dispatcher::idle_slot(const Job& job) {
    if (job.alone) {
        while (!slots_.empty()) { dismiss(slots_.begin()); }
    }
    const auto idle = std::find_if(slots_.begin(), slots_.end(), [](const Slot& slot) { return !slot.job; });
    if (idle != slots_.end()) { return &*idle; }
    std::string reason;
    Worker worker = forker_.spawn(job.alone ? resources_.memory : resources_.memory / resources_.workers, reason);
    if (worker) {
        slots_.push_back({std::move(worker), {}, {}, 0, 0, {}});
        return &slots_.back();
    }
    if (slots_.empty()) { throw FileError("no worker process can be started: " + reason); }
    note_once(fmt::format("{} of {} workers are at work; no more can be started: {}", slots_.size(), resources_.workers,
                          reason));
    resources_.workers = static_cast<unsigned>(slots_.size());
    return nullptr;
}

void Dispatcher::dismiss(Slots::iterator slot) {
    forker_.release(slot->worker);
    slots_.erase(slot);
}

void Dispatcher::dismiss_idle() {
    for (auto slot = slots_.begin(); slot != slots_.end();) {
        const auto here = slot++;
        if (!here->job) { dismiss(here); }
    }
}

void Dispatcher::watch_interrupt() {
    if (!stopped_ && InterruptGuard::requested()) {
        stopped_ = Clock::now();
        forker_.interrupt();
    }
    given_up_ = stopped_ && seconds_since(*stopped_) > resources_.grace;
}

void Dispatcher::wait() {
    std::vector<pollfd> ends;
    for (const Slot& slot : slots_) { ends.push_back({slot.worker.socket.number(), POLLIN, 0}); }
    if (::poll(ends.data(), ends.size(), look_up) <= 0) { return; }
    auto slot = slots_.begin();
    for (const pollfd& end : ends) {
        const auto here = slot++;  // which may be removed
        if (end.revents != 0) { receive(here); }
    }
    if (is_amid_batch()) { std::this_thread::sleep_for(nap); }
}

void Dispatcher::receive(Slots::iterator slot) {
    if (!slot->answers.read(slot->worker.socket)) { return bury(slot); }
    while (const auto answer = slot->answers.next()) {
        if (answer->empty() || !slot->job) { return bury(slot); }
        if (!take_answer(slot, static_cast<Answered>(answer->at(0)), answer->substr(1))) { return; }
    }
    if (slot->answers.is_broken()) { bury(slot); }
}

void Dispatcher::bury(Slots::iterator slot) {
    const BadEnd end = bad_end(forker_.bury(slot->worker));
    const std::string printed = slot->worker.printed.take();
    if (end.of_time) {
        const std::string detail =
            fmt::format("it has taken the CPU time of {} s that --timeout allows", resources_.timeout);
        return end_badly(slot, status::timeout, with_printed(detail, printed));
    }
    end_badly(slot, status::with_reason(status::crashed, end.by), with_printed(end.detail, printed));
}

bool Dispatcher::is_amid_batch() const {
    return std::any_of(slots_.begin(), slots_.end(), [](const Slot& slot) { return slot.job && slot.answered > 0; });
}

bool Dispatcher::take_answer(Slots::iterator slot, Answered kind, const std::string& text) {
    if (kind == Answered::file_error) { throw FileError(text); }
    if (kind == Answered::no_memory) {
        forker_.bury(slot->worker);  // what is left of its memory is in disorder
        end_badly(slot, status::out_of_memory, memory_detail(text));
        return false;
    }
    account(*slot, kind);
    if (slot->job->kind == Job::Kind::reference) {
        take_reference_answer(*slot->job, kind, text);
    } else {
        take_cell_answer(*slot, kind, text);
        if (++slot->answered < slot->job->cells.size()) { return true; }
    }
    const bool was_alone = slot->job->alone;
    slot->job.reset();
    if (was_alone) { dismiss(slot); }
    return !was_alone;
}

void Dispatcher::take_cell_answer(Slot& slot, Answered kind, const std::string& text) {
    const std::size_t index = slot.job->cells[slot.answered];
    switch (kind) {
        case Answered::record:
            ledger_.record(index, ending_in(text), std::string(line_in(text)));
            break;
        case Answered::part:
            ledger_.record_part(text);
            break;
        case Answered::seconds:
            ledger_.note_seconds(index, text.empty() ? std::nullopt : std::optional(std::stod(text)));
            break;
        default:
            break;  // interrupted, which leaves nothing
    }
    if (kind == Answered::record) {
        schedule_.learn(index, std::chrono::duration<double>(Clock::now() - slot.since).count());
    }
    slot.since = Clock::now();
}

void Dispatcher::take_reference_answer(const Job& job, Answered kind, const std::string& text) {
    if (kind == Answered::interrupted) { return; }
    if (kind == Answered::no_reference) { return reference_failed(job.reference, status::exception, text); }
    if (!text.empty()) { note_once("references are kept in the results only: " + text); }
    ++ledger_.progress.references_done;
    schedule_.reference_done(job.reference);
}

void Dispatcher::end_badly(Slots::iterator slot, const std::string& status, const std::string& detail) {
    if (slot->job) {
        const JobAtWork lost = at_work(*slot);
        effort_of(*slot->job).lose(done_of(lost), lost.taken);
    }
    const std::optional<Job> job = std::move(slot->job);
    const std::size_t answered = slot->answered;
    slots_.erase(slot);
    if (!job || stopped_) { return; }
    const std::size_t index = job->kind == Job::Kind::reference ? 0 : job->cells[answered];
    for (std::size_t i = answered + 1; i < job->cells.size(); ++i) { schedule_.take_back(job->cells[i]); }
    const bool was_alone = job->alone || (status == status::timeout && job->cells.size() <= 1);
    if (was_alone || job->kind == Job::Kind::round) { return conclude(*job, index, status, detail); }
    const bool of_reference = job->kind == Job::Kind::reference;
    schedule_.add_alone({job->kind, job->reference, of_reference ? std::vector<std::size_t>() : std::vector{index}});
}

void Dispatcher::conclude(const Job& job, std::size_t index, const std::string& status, const std::string& detail) {
    effort_of(job).drop(cost_of(job, 0));  // of one cell, if of any
    if (job.kind == Job::Kind::reference) { return reference_failed(job.reference, status, detail); }
    if (job.kind == Job::Kind::round) { return ledger_.note_seconds(index, {}); }
    ledger_.record(index, ended(status, detail));
}

void Dispatcher::reference_failed(const std::string& hash, const std::string& status, const std::string& detail) {
    ++ledger_.progress.references_done;
    failed_[hash] = {status, detail};
    for (const std::size_t index : schedule_.take_waiting(hash)) {
        ledger_.record(index, ended(status::with_reason(status::no_reference, status), detail));
        efforts_.cells.drop(plan_.cells[index].weight);
    }
}

std::string Dispatcher::memory_detail(const std::string& printed) const {
    const double megabytes = static_cast<double>(resources_.memory) / (1U << 20U);
    const std::string detail = fmt::format("memory was refused; --max-memory allows {:.0f} MB", megabytes);
    return printed.empty() ? detail : detail + "; " + printed;
}

void Dispatcher::note_once(const std::string& note) {
    if (std::find(notes_.begin(), notes_.end(), note) == notes_.end()) { notes_.push_back(note); }
}

}  // namespace kreisel
