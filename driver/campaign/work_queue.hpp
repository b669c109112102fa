// SPDX-License-Identifier: BSD-3-Clause
//
// The queue from which workers take their work: reference solutions first, then cells, long ones first, each cell as
// soon as its reference is available.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <mutex>
#include <optional>
#include <set>
#include <stop_token>
#include <string>
#include <vector>

namespace kreisel {

/// A reference (its hash) or a cell (its index).
struct WorkItem {
    std::string reference;
    std::size_t cell = 0;
};

class WorkQueue {
  public:
    void add_reference(const std::string& hash) { references_.push_back(hash); }
    /// Cells are handed out in the order they are added.
    void add_cell(std::size_t index, const std::string& needs) { cells_.push_back({index, needs}); }

    /// The next item that is ready; waits for a reference if necessary. Nothing when all is done or a stop is
    /// requested.
    std::optional<WorkItem> take(const std::stop_token& stop);
    /// A reference has been computed, or has failed: the cells that wait for it become ready.
    void reference_done(const std::string& hash);

  private:
    struct WaitingCell {
        std::size_t index;
        std::string needs;
    };
    std::optional<WorkItem> next_ready();

    std::mutex mutex_;
    std::condition_variable_any changed_;
    std::deque<std::string> references_;
    std::deque<WaitingCell> cells_;
    std::set<std::string> done_;
};

}  // namespace kreisel
