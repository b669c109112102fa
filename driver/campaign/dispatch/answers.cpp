// SPDX-License-Identifier: BSD-3-Clause
//
// What follows from the answers of workers, and from their ends.
#include <fmt/format.h>

#include "driver/campaign/cell_run.hpp"
#include "driver/campaign/dispatch/dispatcher.hpp"
#include "support/errors.hpp"

namespace kreisel {

bool Dispatcher::take_answer(Slots::iterator slot, Answered kind, const std::string& text) {
    if (kind == Answered::file_error) { throw FileError(text); }
    if (kind == Answered::no_memory) {
        forker_.bury(slot->worker);  // what is left of its memory is in disorder
        end_badly(slot, status::out_of_memory, memory_detail(text));
        return false;
    }
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
    if (job.kind == Job::Kind::reference) { return reference_failed(job.reference, status, detail); }
    if (job.kind == Job::Kind::round) { return ledger_.note_seconds(index, {}); }
    ledger_.record(index, ended(status, detail));
}

void Dispatcher::reference_failed(const std::string& hash, const std::string& status, const std::string& detail) {
    ++ledger_.progress.references_done;
    failed_[hash] = {status, detail};
    for (const std::size_t index : schedule_.take_waiting(hash)) {
        ledger_.record(index, ended(status::with_reason(status::no_reference, status), detail));
    }
}

std::string Dispatcher::memory_detail(const std::string& printed) const {
    const double megabytes = static_cast<double>(resources_.memory) / (1U << 20U);
    const std::string detail = fmt::format("memory was refused; --max-memory allows {:.0f} MB", megabytes);
    return printed.empty() ? detail : detail + "; " + printed;
}

}  // namespace kreisel
