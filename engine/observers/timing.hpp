// SPDX-License-Identifier: BSD-3-Clause
//
// Time and memory of a run.
#pragma once

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// CPU time of this thread, s.
double thread_seconds();

/// Bytes on the heap of the whole process [glibc]; other threads' allocations count too, so timed cells run one at a
/// time. The allocator keeps blocks of earlier cells and counts them as used, so differences of a few kB are noise.
/// Zero under sanitizers, where malloc is not the C library's.
double heap_bytes();

/// A run is repeated in several rounds, in each of them until it has taken its share of the time that makes the fastest
/// round reliable. Within a round the mean counts: a virtual machine's clock of CPU time is corrected in arrears for
/// what the host took away, so that single short runs are charged too little, down to nothing.
class RepeatedTimes {
  public:
    bool enough() const;
    void add(double seconds);
    double mean() const { return total_ / runs_; }  ///< s

  private:
    int runs_ = 0;
    double total_ = 0;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
