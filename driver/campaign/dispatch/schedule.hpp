// SPDX-License-Identifier: BSD-3-Clause
//
// What is left to do: reference solutions first, then cells, long ones first, each as soon as its reference is there;
// short ones in batches, so that messages cost little. Internal to the campaign.
#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <queue>
#include <string>
#include <utility>
#include <vector>

#include "driver/campaign/dispatch/job.hpp"

namespace kreisel {

class Schedule {
  public:
    /// `batches`: whether cells may be put together.
    explicit Schedule(bool batches) : batches_(batches) {}

    void add_reference(const std::string& hash) { references_.push_back(hash); }
    /// `needs`: a reference that was added; empty: none.
    void add_cell(std::size_t index, const std::string& needs, double weight);
    /// Something that is done when no other worker is at work.
    void add_alone(Job job);
    void add_round(std::size_t cell) { rounds_.push_back(cell); }

    /// The cells that wait for a reference become ready.
    void reference_done(const std::string& hash);
    /// Takes them out, since there will be no reference.
    std::vector<std::size_t> take_waiting(const std::string& hash);
    /// Takes back a cell, or a job, that was handed out.
    void take_back(std::size_t index);
    void give_back(const Job& job);
    /// The next job; `idle`: no worker is at work, as a job that runs alone requires.
    std::optional<Job> next(bool idle);
    /// What a cell has taken, from which the size of batches follows.
    void learn(std::size_t index, double seconds);
    /// Whether something may still be handed out.
    bool empty() const { return references_.empty() && ready_.empty() && alone_.empty() && rounds_.empty(); }

  private:
    using Ready = std::pair<double, std::size_t>;  // minus the weight, the index
    Job next_batch();

    const bool batches_;
    std::deque<std::string> references_;
    std::map<std::string, std::vector<std::size_t>> waiting_;
    std::priority_queue<Ready, std::vector<Ready>, std::greater<>> ready_;
    std::deque<Job> alone_;
    std::deque<std::size_t> rounds_;
    std::vector<double> weights_;  // by index
    double seconds_ = 0, weight_ = 0;
};

}  // namespace kreisel
