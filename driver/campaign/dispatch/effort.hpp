// SPDX-License-Identifier: BSD-3-Clause
//
// How much of a run is done and how long the rest takes, from what jobs were estimated to cost and what they have
// taken. Internal to the campaign.
#pragma once

#include <vector>

namespace kreisel {

/// Jobs of one kind. Costs are estimated seconds; one of them may take any time, but all alike.
class Effort {
  public:
    void add(double cost) { total_ += cost; }
    /// One that is not to be done any more.
    void drop(double cost) { total_ -= cost; }
    /// All that are not done.
    void drop_rest() { total_ = done_; }
    /// One, or a part of it, is done, and has taken so many seconds.
    void end(double cost, double taken);
    /// The same of a part that is to be done again.
    void lose(double cost, double taken);

    double total() const { return total_; }
    double done() const { return done_; }
    /// Seconds that a cost of one takes. Until a two-hundredth is done, the estimate counts for more than what little
    /// was measured.
    double pace() const;
    double seconds_left() const { return (total_ - done_) * pace(); }

  private:
    double total_ = 0, done_ = 0;
    double worked_ = 0;   // cost of what was done, in vain too
    double seconds_ = 0;  // that it took
};

/// Of a run: references and cells, whose estimates err by different factors.
struct Efforts {
    Effort references, cells;
};

/// A job that a worker is at.
struct JobAtWork {
    bool is_reference = false;
    double cost = 0;
    double share = 0;  ///< of it that is done; what is no number from 0 to 1 is taken for the nearest of these
    double taken = 0;  ///< s
};

/// The cost of what is done of it.
double done_of(const JobAtWork& job);

struct Outlook {
    double share = 0;         ///< of the cost of all that is done
    double seconds_left = 0;  ///< of the workers together, but no less than one job at work still takes
};

/// What is to be expected of a run with so many workers.
Outlook outlook(Efforts efforts, const std::vector<JobAtWork>& at_work, unsigned workers);

}  // namespace kreisel
