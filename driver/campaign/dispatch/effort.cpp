// SPDX-License-Identifier: BSD-3-Clause
#include "driver/campaign/dispatch/effort.hpp"

#include <algorithm>

namespace kreisel {

namespace {

constexpr double presumed = 1.0 / 200;  // of all, to have been done before in the time that was estimated

Effort& effort_of(Efforts& efforts, const JobAtWork& job) {
    return job.is_reference ? efforts.references : efforts.cells;
}

}  // namespace

void Effort::end(double cost, double taken) {
    done_ += cost;
    lose(cost, taken);
}

void Effort::lose(double cost, double taken) {
    worked_ += cost;
    seconds_ += taken;
}

double Effort::pace() const {
    const double before = presumed * total_, known = worked_ + before;
    return known > 0 ? (seconds_ + before) / known : 1;
}

// A worker may write anything, a number that is none too.
double done_of(const JobAtWork& job) { return job.share > 0 ? std::min(job.share, 1.0) * job.cost : 0; }

Outlook outlook(Efforts efforts, const std::vector<JobAtWork>& at_work, unsigned workers) {
    for (const JobAtWork& job : at_work) { effort_of(efforts, job).end(done_of(job), job.taken); }
    const double total = efforts.references.total() + efforts.cells.total();
    const double left = efforts.references.seconds_left() + efforts.cells.seconds_left();
    Outlook expected{total > 0 ? (efforts.references.done() + efforts.cells.done()) / total : 0, left / workers};
    for (const JobAtWork& job : at_work) {
        const double alone = (job.cost - done_of(job)) * effort_of(efforts, job).pace();
        expected.seconds_left = std::max(expected.seconds_left, alone);
    }
    return expected;
}

}  // namespace kreisel
