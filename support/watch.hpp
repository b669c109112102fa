// SPDX-License-Identifier: BSD-3-Clause
//
// What a long computation looks at on its way: whether it shall stop, and where it says how far it is.
#pragma once

#include <atomic>
#include <stop_token>
#include <utility>

namespace kreisel {

/// How far a computation is, for whoever looks at it meanwhile, from another process too.
using Share = std::atomic<double>;
static_assert(Share::is_always_lock_free, "processes share it");

class Watch {
  public:
    /// Of a computation that nobody stops or looks at.
    Watch() = default;
    /// `told` may be null; otherwise it outlives the watch.
    Watch(std::stop_token stop, Share* told = nullptr)  // NOLINT(google-explicit-constructor): one without a listener
        : stop_(std::move(stop)), told_(told) {}

    bool stop_requested() const { return stop_.stop_requested(); }

    /// The share of the computation that is done, from 0 to 1; it never falls. Costs a few instructions.
    void tell(double share) const {
        if (told_ != nullptr) { told_->store(begin_ + (end_ - begin_) * share, std::memory_order_relaxed); }
    }

    /// For a part that begins and ends at such shares of the whole.
    Watch part(double begin, double end) const {
        Watch of_part = *this;
        of_part.begin_ = begin_ + (end_ - begin_) * begin;
        of_part.end_ = begin_ + (end_ - begin_) * end;
        return of_part;
    }

  private:
    std::stop_token stop_;
    Share* told_ = nullptr;
    double begin_ = 0, end_ = 1;  // what is told for 0 and for 1
};

}  // namespace kreisel
