// SPDX-License-Identifier: BSD-3-Clause
#include "driver/campaign/work_queue.hpp"

#include <algorithm>

namespace kreisel {

std::optional<WorkItem> WorkQueue::next_ready() {
    if (!references_.empty()) {
        WorkItem item{references_.front(), 0};
        references_.pop_front();
        return item;
    }
    const auto ready = std::find_if(cells_.begin(), cells_.end(), [this](const WaitingCell& cell) {
        return cell.needs.empty() || done_.contains(cell.needs);
    });
    if (ready == cells_.end()) { return std::nullopt; }
    WorkItem item{"", ready->index};
    cells_.erase(ready);
    return item;
}

std::optional<WorkItem> WorkQueue::take(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    while (!stop.stop_requested() && (!references_.empty() || !cells_.empty())) {
        if (auto item = next_ready()) { return item; }
        const std::size_t seen = done_.size();
        changed_.wait(lock, stop, [&] { return done_.size() != seen; });
    }
    return std::nullopt;
}

void WorkQueue::reference_done(const std::string& hash) {
    {
        const std::lock_guard lock(mutex_);
        done_.insert(hash);
    }
    changed_.notify_all();
}

}  // namespace kreisel
