// SPDX-License-Identifier: BSD-3-Clause
#include "driver/campaign/dispatch/schedule.hpp"

namespace kreisel {

namespace {

// Short beside a run, long beside a message.
constexpr double batch_seconds = 0.02;
constexpr std::size_t largest_batch = 256;

}  // namespace

void Schedule::add_cell(std::size_t index, const std::string& needs, double weight) {
    if (index >= weights_.size()) { weights_.resize(index + 1, 0); }
    weights_[index] = weight;
    needs.empty() ? take_back(index) : waiting_[needs].push_back(index);
}

void Schedule::add_alone(Job job) {
    job.alone = true;
    alone_.push_back(std::move(job));
}

void Schedule::take_back(std::size_t index) { ready_.emplace(-weights_.at(index), index); }

void Schedule::give_back(const Job& job) {
    if (job.alone) { return alone_.push_front(job); }
    if (job.kind == Job::Kind::reference) { return references_.push_front(job.reference); }
    if (job.kind == Job::Kind::round) { return rounds_.push_front(job.cells.front()); }
    for (const std::size_t index : job.cells) { take_back(index); }
}

std::vector<std::size_t> Schedule::take_waiting(const std::string& hash) {
    const auto found = waiting_.find(hash);
    if (found == waiting_.end()) { return {}; }
    std::vector<std::size_t> cells = std::move(found->second);
    waiting_.erase(found);
    return cells;
}

void Schedule::reference_done(const std::string& hash) {
    for (const std::size_t index : take_waiting(hash)) { take_back(index); }
}

void Schedule::learn(std::size_t index, double seconds) {
    seconds_ += seconds;
    weight_ += weights_.at(index);
}

Job Schedule::next_batch() {
    Job job{Job::Kind::cells, {}, {}};
    double expected = 0;
    do {
        const auto [minus_weight, index] = ready_.top();
        ready_.pop();
        job.cells.push_back(index);
        expected += weight_ > 0 ? -minus_weight * seconds_ / weight_ : batch_seconds;
    } while (batches_ && !ready_.empty() && expected < batch_seconds && job.cells.size() < largest_batch);
    return job;
}

std::optional<Job> Schedule::next(bool idle) {
    if (!references_.empty()) {
        Job job{Job::Kind::reference, references_.front(), {}};
        references_.pop_front();
        return job;
    }
    if (!ready_.empty()) { return next_batch(); }
    if (!idle) { return std::nullopt; }
    if (!alone_.empty()) {
        Job job = std::move(alone_.front());
        alone_.pop_front();
        return job;
    }
    if (rounds_.empty()) { return std::nullopt; }
    Job job{Job::Kind::round, {}, {rounds_.front()}};
    rounds_.pop_front();
    return job;
}

}  // namespace kreisel
