// SPDX-License-Identifier: BSD-3-Clause
#include "engine/observers/timing.hpp"

#include <malloc.h>

#include <ctime>

#include "engine/engine.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

// Of all rounds together.
constexpr double least_seconds = 0.25;

}  // namespace

double thread_seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) / 1000000000;
}

double heap_bytes() {
    const struct mallinfo2 info = mallinfo2();
    return static_cast<double>(info.uordblks + info.hblkhd);
}

bool RepeatedTimes::enough() const { return runs_ > 0 && total_ >= least_seconds / timing_rounds; }

void RepeatedTimes::add(double seconds) {
    total_ += seconds;
    ++runs_;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
