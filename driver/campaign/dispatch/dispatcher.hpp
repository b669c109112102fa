// SPDX-License-Identifier: BSD-3-Clause
//
// Hands the work of a run to worker processes and writes down what they answer. It waits in one place only, for
// answers, and has no threads. Internal to the campaign.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <list>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "driver/campaign/dispatch/effort.hpp"
#include "driver/campaign/dispatch/job.hpp"
#include "driver/campaign/dispatch/ledger.hpp"
#include "driver/campaign/dispatch/schedule.hpp"
#include "driver/campaign/workers/forker.hpp"
#include "driver/campaign/workers/message.hpp"

namespace kreisel {

/// What the workers of a run may use.
struct Resources {
    unsigned workers = 1;
    std::uint64_t memory = 0;  ///< bytes, of all together
    double timeout = 0;        ///< s of CPU time of a cell, for messages; 0: any
    double grace = 1;          ///< s that interrupted workers get to finish before they are killed
};

/// How a reference failed.
struct FailedReference {
    std::string status, detail;
};
using FailedReferences = std::map<std::string, FailedReference>;  // by hash

/// Cells that end badly are run again alone, with all memory, in a new worker, and that outcome counts: memory that
/// other cells have taken, or left in disorder, decides nothing. CPU time is the cell's own, so that a cell that was
/// by itself in its batch is not given its time twice.
class Dispatcher {
  public:
    Dispatcher(const Plan& plan, const Forker& forker, Ledger& ledger, const Resources& resources,
               std::function<void(Dispatcher&)> show)
        : plan_(plan),
          forker_(forker),
          ledger_(ledger),
          resources_(resources),
          schedule_(!plan.config.runs_alone()),
          show_(std::move(show)) {}

    /// The references in question, all or those that cells need, and the cells.
    void enqueue(const std::vector<std::string>& references, const std::vector<std::size_t>& cells);
    /// Does what was enqueued; ends early, with cells left, after an interrupt. Throws FileError.
    void run();
    /// Takes further rounds of CPU times, all cells in each round, so that a busy moment of the machine meets all
    /// alike.
    void time_in_turn();

    /// Lets the workers go; those at work after an interrupt are left to the forker.
    void dismiss_idle();

    /// What is done, and what is to be expected. The share never falls: where a job has to begin again it stays until
    /// that one is as far as it was.
    ProgressState progress();

    const FailedReferences& failed_references() const { return failed_; }
    /// Something the user should know, one line each.
    const std::vector<std::string>& notes() const { return notes_; }
    bool interrupted() const { return stopped_.has_value(); }
    /// Of what was enqueued.
    bool has_left_something() const;

  private:
    using Clock = std::chrono::steady_clock;
    struct Slot {
        Worker worker;
        MessageReader answers;
        std::optional<Job> job;
        std::size_t answered = 0;  // of the job
        std::size_t given = 0;     // answers, ever
        Clock::time_point since;   // the job has begun, or its last answer was given
    };
    using Slots = std::list<Slot>;

    Effort& effort_of(const Job& job) {
        return job.kind == Job::Kind::reference ? efforts_.references : efforts_.cells;
    }
    double cost_of(const Job& job, std::size_t at) const;
    JobAtWork at_work(const Slot& slot) const;
    void account(Slot& slot, Answered kind);
    bool busy() const;
    bool alone() const;
    void assign();
    bool start(Job job);
    Slot* idle_slot(const Job& job);
    void wait();
    void watch_interrupt();
    void receive(Slots::iterator slot);
    void bury(Slots::iterator slot);
    bool is_amid_batch() const;
    /// False if the slot is no more.
    bool take_answer(Slots::iterator slot, Answered kind, const std::string& text);
    void take_cell_answer(Slot& slot, Answered kind, const std::string& text);
    void take_reference_answer(const Job& job, Answered kind, const std::string& text);
    void end_badly(Slots::iterator slot, const std::string& status, const std::string& detail);
    void conclude(const Job& job, std::size_t index, const std::string& status, const std::string& detail);
    void reference_failed(const std::string& hash, const std::string& status, const std::string& detail);
    void dismiss(Slots::iterator slot);
    std::string memory_detail(const std::string& printed) const;
    void note_once(const std::string& note);

    const Plan& plan_;
    const Forker& forker_;
    Ledger& ledger_;
    Resources resources_;
    Schedule schedule_;
    std::function<void(Dispatcher&)> show_;
    Slots slots_;
    Efforts efforts_;
    double share_shown_ = 0;
    FailedReferences failed_;
    std::vector<std::string> notes_;
    std::optional<Clock::time_point> stopped_;
    bool given_up_ = false;
    std::size_t enqueued_ = 0;  // cells that there are when all is done
};

}  // namespace kreisel
