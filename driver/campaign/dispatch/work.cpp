// SPDX-License-Identifier: BSD-3-Clause
#include "driver/campaign/dispatch/work.hpp"

#include <fmt/format.h>

#include <csignal>
#include <new>

#include "driver/campaign/cell_run.hpp"
#include "driver/campaign/workers/limits.hpp"
#include "driver/campaign/workers/message.hpp"
#include "records/cell/line.hpp"
#include "support/errors.hpp"

namespace kreisel {

namespace {

// A method that has closed the socket has taken its worker from the run.
void answer(const Descriptor& socket, const std::string& text) {
    if (!send_message(socket, text)) { ::raise(SIGKILL); }
}

}  // namespace

std::string with_printed(const std::string& detail, const std::string& printed) {
    if (printed.empty()) { return detail; }
    return detail.empty() ? "it printed: " + printed : detail + "; it printed: " + printed;
}

void WorkerTasks::serve(const Descriptor& socket, const Printed& printed, const Watch& watch) {
    double given = 0;  // answers
    const auto give = [&](const std::string& text) {
        watch.tell(++given);  // first: who has the answer knows that it is complete
        answer(socket, text);
    };
    while (const auto text = receive_message(socket)) {
        const Job job = Job::read(*text);
        try {
            if (job.kind == Job::Kind::reference) {
                give(answer_reference(job.reference, printed, watch.part(given, given + 1)));
            }
            for (const std::size_t index : job.cells) {
                const PlannedCell& planned = plan_.cells[index];
                const Watch one = watch.part(given, given + 1);
                const bool round = job.kind == Job::Kind::round;
                give(round ? answer_round(planned, one) : answer_cell(planned, printed, one));
            }
        } catch (const FileError& error) {
            answer(socket, answer_text(Answered::file_error, error.what()));
        } catch (const std::bad_alloc&) {  // what cannot be written down in the share
            answer(socket, answer_text(Answered::no_memory));
        }
    }
}

std::string WorkerTasks::answer_reference(const std::string& hash, const Printed& printed, const Watch& watch) const {
    const PlannedReference& planned = plan_.references.at(hash);
    auto stored = store_.find(planned);
    if (!stored) {
        const ThingLock lock = store_.lock(planned);
        stored = store_.find(planned);  // by whoever had the lock before
        if (!stored && !lock.held()) { return answer_text(Answered::interrupted); }
        if (!stored) { return compute_reference(planned, printed, watch); }
    }
    return answer_text(Answered::found, store_.keep(planned, *stored));
}

std::string WorkerTasks::compute_reference(const PlannedReference& planned, const Printed& printed,
                                           const Watch& watch) const {
    Reference reference;
    try {
        const CpuLimit limit(timeout_);
        reference = engines_.quad().reference(planned.problem, planned.parameters, planned.begin.get(), planned.t_end,
                                              planned.samples, watch);
    } catch (const std::bad_alloc&) { throw; } catch (const std::exception& error) {
        return answer_text(Answered::no_reference, with_printed(error.what(), printed.take()));
    } catch (...) { return answer_text(Answered::no_reference, with_printed(not_an_exception, printed.take())); }
    printed.take();
    if (reference.interrupted) { return answer_text(Answered::interrupted); }
    return answer_text(Answered::reference, store_.keep(planned, store_.make(planned, reference)));
}

const Reference* WorkerTasks::reference_of(const PlannedCell& planned) {
    const std::string& hash = planned.reference();
    if (hash.empty()) { return nullptr; }
    const auto known = references_.find(hash);
    if (known != references_.end()) { return &known->second; }
    auto stored = store_.find(plan_.references.at(hash));
    if (!stored) { throw FileError(fmt::format("{}: cannot be read", reference_file(folder_, hash).string())); }
    return &references_.emplace(hash, std::move(stored->reference)).first->second;
}

std::string WorkerTasks::answer_cell(const PlannedCell& planned, const Printed& printed, const Watch& watch) {
    if (watch.stop_requested()) { return answer_text(Answered::interrupted); }
    const Reference* reference = reference_of(planned);
    const bool sampled = planned.run->cell.samples > 0;
    TrajectoryFile samples(sampled ? folder_ / trajectory_file(planned.hash()) : std::filesystem::path());
    Outcome outcome;
    {
        const CpuLimit limit(timeout_);
        outcome = run_cell(planned, engines_.of(planned.precision()), reference, watch, &samples);
    }
    outcome.detail = with_printed(outcome.detail, printed.take());
    if (outcome.status == status::interrupted) { return answer_part(planned, samples); }
    return answer_outcome(planned, outcome, reference, samples);
}

std::string WorkerTasks::answer_outcome(const PlannedCell& planned, const Outcome& outcome, const Reference* reference,
                                        TrajectoryFile& samples) const {
    if (outcome.status == status::out_of_memory) {
        samples.discard();
        return answer_text(Answered::no_memory, outcome.detail);
    }
    CellRecord cell = record_of_run(planned, outcome, reference, samples.sum());
    std::string line;
    try {
        line = journal_line(cell, build_);
    } catch (const std::logic_error& error) {  // a number that is not finite
        cell = record_of(planned, ended(status::exception, error.what()), reference);
        line = journal_line(cell, build_);
    }
    cell.outcome.trajectory_sum.empty() ? samples.discard() : samples.keep();
    return answer_text(Answered::record, record_text(ending_of(cell.outcome), line));
}

std::string WorkerTasks::answer_part(const PlannedCell& planned, TrajectoryFile& samples) const {
    samples.flush();
    if (samples.sum().empty()) { return answer_text(Answered::interrupted); }
    const Outcome outcome = ended(status::interrupted, "its samples so far are in a part of its trajectory");
    return answer_text(Answered::part, journal_line(record_of(planned, outcome, nullptr), build_));
}

std::string WorkerTasks::answer_round(const PlannedCell& planned, const Watch& watch) const {
    const CpuLimit limit(timeout_);
    const auto run_s = engines_.of(planned.precision()).run_time(planned.cell(), watch);
    return answer_text(Answered::seconds, run_s ? fmt::format("{}", *run_s) : "");
}

}  // namespace kreisel
