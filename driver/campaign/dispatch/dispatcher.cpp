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
    for (const std::string& hash : references) { schedule_.add_reference(hash); }
    ledger_.progress.references += references.size();
    enqueued_ = ledger_.finished().size() + cells.size();
    for (const std::size_t index : cells) {
        const PlannedCell& planned = plan_.cells[index];
        if (planned.skip_reason().empty()) {
            schedule_.add_cell(index, planned.reference(), planned.weight);
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
        show_();
    }
}

bool Dispatcher::has_left_something() const {
    const ProgressState& progress = ledger_.progress;
    return progress.references_done < progress.references || ledger_.finished().size() < enqueued_;
}

void Dispatcher::time_in_turn() {
    const std::vector<std::size_t> cells = ledger_.timed_cells();
    for (int round = 1; round < timing_rounds; ++round) {
        for (const std::size_t index : cells) { schedule_.add_round(index); }
    }
    run();
    if (!stopped_) { ledger_.record_times(cells); }
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
        slots_.push_back({std::move(worker), {}, {}, 0, {}});
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

void Dispatcher::note_once(const std::string& note) {
    if (std::find(notes_.begin(), notes_.end(), note) == notes_.end()) { notes_.push_back(note); }
}

}  // namespace kreisel
