// SPDX-License-Identifier: BSD-3-Clause
//
// A process that forks the workers of a run. It is made before any thread, lock or journal: a child of a process with
// threads may do next to nothing, and a worker that holds the descriptor of a lock holds the lock. It lives as long as
// its object, and no worker outlives it, even if one of them or this program is killed.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "driver/campaign/workers/printed.hpp"
#include "driver/campaign/workers/shares.hpp"
#include "support/files.hpp"
#include "support/watch.hpp"

namespace kreisel {

/// A worker as the campaign sees it.
struct Worker {
    pid_t process = -1;
    Descriptor socket;              ///< for messages (message.hpp)
    Printed printed{Descriptor()};  ///< what it prints
    const Share* told = nullptr;    ///< what it tells its watch; may be null
    explicit operator bool() const { return process > 0; }
};

/// What runs in a worker, until its socket is closed. The watch asks to stop after Forker::interrupt, and the program
/// sees what it is told.
using WorkerMain = std::function<void(const Descriptor& socket, const Printed&, const Watch&)>;

class Forker {
  public:
    /// Throws FileError if the process cannot be started.
    explicit Forker(const WorkerMain& work);
    /// Kills the workers and waits for their end.
    ~Forker();
    Forker(const Forker&) = delete;
    Forker& operator=(const Forker&) = delete;

    /// A new worker that may have so many bytes of data. None if the system refuses it: `reason` says why.
    Worker spawn(std::uint64_t memory, std::string& reason) const;
    /// Lets a worker that waits for work come to its own end. One that takes longer than a second is killed.
    void release(Worker& worker) const;
    /// Kills a worker if it lives; returns how it ended, as waitpid reports it.
    int bury(const Worker& worker) const;
    /// Asks all workers to stop.
    void interrupt() const;

  private:
    Shares shares_;  // before the fork
    Descriptor control_;
    pid_t process_ = -1;
};

}  // namespace kreisel
